#include "engine/case/case_words.h"

#include <gtest/gtest.h>

#include <set>

namespace plumb {
namespace case_words_test {

TEST(CaseWords, AreThoseOfTheCaseFiles) {
  EXPECT_EQ(word(CableModel::chain), "chain");
  EXPECT_EQ(word(StrainModel::engineering_material), "engineering-material");
  EXPECT_EQ(word(QuadratureRule::reduced), "reduced");
  EXPECT_EQ(word(Support::clamped), "clamped");
  EXPECT_EQ(word(SlopeRates::zero), "zero");
  EXPECT_EQ(word(Quantity::bending_moment), "bending-moment");
  EXPECT_EQ(word(Norm::rms), "rms");
}

template <class E>
void expect_unique() {
  std::set<std::string_view> seen;
  for (const auto& entry : words_of<E>) EXPECT_TRUE(seen.insert(entry.word).second) << entry.word;
}

TEST(CaseWords, AreEachUsedOnce) {
  expect_unique<CableModel>();
  expect_unique<StrainModel>();
  expect_unique<QuadratureRule>();
  expect_unique<Support>();
  expect_unique<SlopeRates>();
  expect_unique<Quantity>();
  expect_unique<Norm>();
  expect_unique<View>();
  expect_unique<SceneTheme>();
  expect_unique<SceneBackground>();
  expect_unique<ColorField>();
}

TEST(ProbeColumns, OfAVectorAreThreeAndOfAScalarOne) {
  EXPECT_EQ(column_names({"tip", 1, Quantity::position}),
            (std::vector<std::string>{"tip.x", "tip.y", "tip.z"}));
  EXPECT_EQ(column_names({"tip", 1, Quantity::axial_force}), (std::vector<std::string>{"tip"}));
  for (const auto& entry : words_of<Quantity>) {
    EXPECT_EQ(column_names({"p", 0, entry.value}).size(), is_vector(entry.value) ? 3U : 1U) << entry.word;
  }
}

TEST(ProbeColumns, EachHaveTheUnitOfTheirQuantity) {
  EXPECT_EQ(unit(Quantity::position), "m");
  EXPECT_EQ(unit(Quantity::relative_position), "m");
  EXPECT_EQ(unit(Quantity::velocity), "m/s");
  EXPECT_EQ(unit(Quantity::slope), "1");
  EXPECT_EQ(unit(Quantity::axial_strain), "1");
  EXPECT_EQ(unit(Quantity::axial_force), "N");
  EXPECT_EQ(unit(Quantity::curvature), "1/m");
  EXPECT_EQ(unit(Quantity::bending_moment), "N m");
}

}  // namespace case_words_test
}  // namespace plumb
