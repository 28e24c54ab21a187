#include "engine/study/uncertainty/uncertainty_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/study/uncertainty/comparison_words.h"

namespace plumb {
namespace uncertainty_parts_test {

UncertaintyPart estimated(const char* name, std::vector<double> values) {
  return {name, PartState::estimated, "made", std::move(values)};
}

SeriesUncertainty made_series(std::vector<double> error, std::vector<UncertaintyPart> parts) {
  SeriesUncertainty series;
  series.unit = "m";
  series.published = true;
  for (std::size_t k = 0; k < error.size(); ++k) series.times.push_back(static_cast<double>(k));
  series.error = std::move(error);
  series.parts = std::move(parts);
  conclude(series);
  return series;
}

TEST(UncertaintyParts, TheValidationUncertaintyIsTheRootOfTheSumOfSquares) {
  const SeriesUncertainty series =
      made_series({0, -11, 7}, {estimated("mesh", {0, 3, 3}), estimated("data", {4, 4, 4})});
  EXPECT_EQ(series.validation, (std::vector<double>{4, 5, 5}));
  EXPECT_EQ(series.greatest, 1U);
  EXPECT_NEAR(series.share_within, 2.0 / 3, 1e-15)
      << "|E| of 0 and 7 are within 8 and 10, 11 is not within 10";
  EXPECT_EQ(series.beyond, std::vector<std::size_t>{1});
  EXPECT_EQ(series.finding, "distinguishable at 1 of 3 times, at 1 s: model error between 1 and 21 m at 1 s");
  EXPECT_TRUE(series.whole());
}

TEST(UncertaintyParts, APartThatIsNotEstimatedIsNotZeroButMakesTheRestALowerBound) {
  const UncertaintyPart open{"input", PartState::not_estimated, "nothing is known", {}};
  const SeriesUncertainty series = made_series({3}, {estimated("data", {1}), open});
  EXPECT_FALSE(series.whole());
  EXPECT_EQ(series.finding, "model error between 1 and 5 m, or in wider bounds: not every part is estimated");
  const UncertaintyPart none{"input", PartState::no_part, "the same input", {}};
  EXPECT_TRUE(made_series({3}, {estimated("data", {1}), none}).whole());
}

TEST(UncertaintyParts, WordsSayWhatFollowsOverAllTimes) {
  const auto found = [](std::vector<double> error, double u) {
    const std::vector<double> of_all(error.size(), u);
    return made_series(std::move(error), {estimated("data", of_all)}).finding;
  };
  EXPECT_EQ(found({-1}, 1), "not distinguishable at this uncertainty");
  EXPECT_EQ(found({-1, 2, 0}, 1), "not distinguishable at any of 3 times");
  EXPECT_EQ(found({-3}, 0.5), "model error between 2 and 4 m");
  EXPECT_EQ(found({0, -3, 5, 4, 0}, 0.5),
            "distinguishable at 3 of 5 times, from 1 to 3 s: model error between 4 and 6 m at 2 s");
  EXPECT_EQ(found({-3, 0, 5}, 0.5),
            "distinguishable at 2 of 3 times, between 0 and 2 s: model error between 4 and 6 m at 2 s");
  EXPECT_EQ(found({NAN, 0}, 1), "nothing can be said: it is not a number");
  SeriesUncertainty computed = made_series({3}, {estimated("data", {0.5})});
  computed.published = false;
  conclude(computed);
  EXPECT_EQ(computed.finding, "numerical error between 2 and 4 m")
      << "a computed reference says nothing of the model";
}

TEST(UncertaintyParts, AnOrderThatElementsDoNotHaveIsNoEstimateButABound) {
  const ThreeMeshes meshes{{16, 8, 4}, OfThree::coarsest};
  // 1.6 and 1.8 change by nearly the same: an order of 0.17, by which the error would be called 11 times
  // that.
  for (const double second : {1.8 + 0.2 * std::pow(2, 0.17), 1.8 + 0.2 * std::pow(2, 4.6)}) {
    const UncertaintyPart mesh =
        mesh_part(meshes, {ColumnValues{{1.6}, {}}, ColumnValues{{1.8}, {}}, ColumnValues{{second}, {}}});
    EXPECT_EQ(mesh.state, PartState::bounded) << mesh.how;
    EXPECT_NEAR(mesh.values.at(0), 3 * (second - 1.6) / std::sqrt(3), 1e-12);
    EXPECT_NE(mesh.how.find("to the finest mesh"), std::string::npos) << mesh.how;
  }
  const UncertaintyPart possible =
      mesh_part(meshes, {ColumnValues{{1.6}, {}}, ColumnValues{{1.8}, {}}, ColumnValues{{2.2001}, {}}});
  EXPECT_EQ(possible.state, PartState::estimated) << possible.how;
}

TEST(UncertaintyParts, TheDataHaveTheErrorsOfTheComputationBehindThem) {
  ReferenceSeries series;
  series.unit = "m";
  series.uncertainty = 0.003 * std::sqrt(3);
  series.uncertainty_basis = "a guess";
  const UncertaintyPart data =
      data_part(series, 3, {{"time integration", {0, -0.004 * std::sqrt(3), 0.001}}});
  EXPECT_NEAR(data.values[0], 0.003, 1e-15);
  EXPECT_NEAR(data.values[1], 0.005, 1e-15);
  EXPECT_NEAR(data.values[2], 0.005, 1e-15) << "the greatest up to each time";
  EXPECT_NE(data.how.find("time integration"), std::string::npos) << data.how;
}

TEST(UncertaintyParts, ARunWithoutAResultLeavesItsPartNotEstimatedAndSaysWhy) {
  const ThreeMeshes meshes{{16, 8, 4}, OfThree::coarsest};
  const UncertaintyPart mesh =
      mesh_part(meshes, {ColumnValues{{1}, {}}, ColumnValues{{}, "it blew up"}, ColumnValues{{1}, {}}});
  EXPECT_EQ(mesh.state, PartState::not_estimated);
  EXPECT_TRUE(mesh.values.empty());
  EXPECT_EQ(mesh.how, "the run with 8 elements has no result: it blew up");

  const UncertaintyPart falling =
      mesh_part(meshes, {ColumnValues{{0}, {}}, ColumnValues{{2}, {}}, ColumnValues{{3}, {}}});
  EXPECT_EQ(falling.state, PartState::not_estimated);
  EXPECT_NE(falling.how.find("do not fall"), std::string::npos) << falling.how;

  EXPECT_EQ(time_part({}, {1}, {{}, "no step"}).state, PartState::not_estimated);
}

TEST(UncertaintyParts, MeshesThatAgreeToRoundingAreAnEstimate) {
  const UncertaintyPart mesh =
      mesh_part({{16, 8, 4}, OfThree::coarsest},
                {ColumnValues{{1}, {}}, ColumnValues{{1 + 1e-14}, {}}, ColumnValues{{1}, {}}});
  EXPECT_EQ(mesh.state, PartState::estimated) << mesh.how;
  EXPECT_NEAR(mesh.values.at(0), 1e-14, 1e-15);
}

TEST(UncertaintyParts, TheMeshPartSaysWhichMeshItIsOfAndHow) {
  const UncertaintyPart mesh =
      mesh_part({{16, 8, 4}, OfThree::coarsest},
                {ColumnValues{{1 + 0.01}, {}}, ColumnValues{{1 + 0.04}, {}}, ColumnValues{{1 + 0.16}, {}}});
  ASSERT_EQ(mesh.state, PartState::estimated) << mesh.how;
  EXPECT_NEAR(mesh.values.at(0), 1.25 * 0.16 / std::sqrt(3), 1e-9);
  for (const char* words : {"coarsest of meshes of 16, 8 and 4 elements", "order 2.00", "safety factor 1.25"})
    EXPECT_NE(mesh.how.find(words), std::string::npos) << mesh.how;
}

TEST(UncertaintyParts, FailedSamplesAreLeftOutAndTooFewAreNoEstimate) {
  const ColumnValues failed{{}, "it blew up"};
  const UncertaintyPart part = input_part(1, 1, {ColumnValues{{1, 5}, {}}, failed, ColumnValues{{3, 5}, {}}});
  ASSERT_EQ(part.state, PartState::estimated);
  EXPECT_NEAR(part.values.at(0), std::sqrt(2), 1e-15);
  EXPECT_EQ(part.values.at(1), 0);
  EXPECT_NE(part.how.find("over 2 of 3 samples"), std::string::npos) << part.how;
  EXPECT_EQ(input_part(1, 1, {ColumnValues{{1}, {}}, failed, failed}).state, PartState::not_estimated);
}

TEST(UncertaintyParts, AHalfWidthBecomesAStandardUncertaintyAndSaysHow) {
  ReferenceSeries series;
  series.unit = "m";
  series.uncertainty = 5e-6;
  series.uncertainty_basis = "half a unit of the last printed digit";
  const DataUncertainty rounded = data_uncertainty(series);
  EXPECT_NEAR(rounded.standard, 5e-6 / std::sqrt(3), 1e-20);
  EXPECT_NE(rounded.how.find("the greatest that rounding can do"), std::string::npos) << rounded.how;
  series.uncertainty_basis = "thickness of the line";
  EXPECT_NE(data_uncertainty(series).how.find("no coverage is stated"), std::string::npos);
}

TEST(UncertaintyRuns, MeshesAreCoarserOnesWhereThoseAreStillMeshes) {
  EXPECT_EQ(three_meshes(16).elements, (std::array{16, 8, 4}));
  EXPECT_EQ(three_meshes(16).of, OfThree::finest);
  for (const int elements : {4, 8, 18, 1}) {
    EXPECT_EQ(three_meshes(elements).elements, (std::array{4 * elements, 2 * elements, elements}));
    EXPECT_EQ(three_meshes(elements).of, OfThree::coarsest);
  }
}

}  // namespace uncertainty_parts_test
}  // namespace plumb
