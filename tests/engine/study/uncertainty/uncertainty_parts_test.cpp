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
  EXPECT_EQ(series.finding, "model error between 1 and 21 m");
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

TEST(UncertaintyParts, WordsSayWhatFollows) {
  EXPECT_EQ(comparison_finding(-1, 1, "m", true, true), "not distinguishable at this uncertainty");
  EXPECT_EQ(comparison_finding(-1, 2, "m", true, false), "not distinguishable at this uncertainty");
  EXPECT_EQ(comparison_finding(-3, 1, "m", true, true), "model error between 2 and 4 m");
  EXPECT_EQ(comparison_finding(3, 1, "N", false, true), "numerical error between 2 and 4 N")
      << "a computed reference says nothing of the model";
  EXPECT_EQ(comparison_finding(NAN, 1, "m", true, true), "nothing can be said: it is not a number");
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
  EXPECT_NEAR(mesh.values.at(0), 1.25 * 0.16 / 1.15, 1e-9);
  for (const char* words : {"coarsest of meshes of 16, 8 and 4 elements", "order 2.00", "safety factor 1.25"})
    EXPECT_NE(mesh.how.find(words), std::string::npos) << mesh.how;
}

TEST(UncertaintyParts, FailedSamplesAreLeftOutAndTooFewAreNoEstimate) {
  InputSampling sampling;
  sampling.samples = 3;
  sampling.inputs.resize(1);
  const ColumnValues failed{{}, "it blew up"};
  const UncertaintyPart part =
      input_part(sampling, {ColumnValues{{1, 5}, {}}, failed, ColumnValues{{3, 5}, {}}});
  ASSERT_EQ(part.state, PartState::estimated);
  EXPECT_NEAR(part.values.at(0), std::sqrt(2), 1e-15);
  EXPECT_EQ(part.values.at(1), 0);
  EXPECT_NE(part.how.find("over 2 of 3 samples"), std::string::npos) << part.how;
  EXPECT_EQ(input_part(sampling, {ColumnValues{{1}, {}}, failed, failed}).state, PartState::not_estimated);
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
