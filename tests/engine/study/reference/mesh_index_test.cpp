#include "engine/study/reference/mesh_index.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace mesh_index_test {

/// A solution on a mesh of elements of length h, off by 0.3 t h^p from sin(3t).
std::vector<double> made(double h, double p) {
  std::vector<double> values;
  for (int k = 0; k <= 20; ++k) {
    const double t = 0.1 * k;
    values.push_back(std::sin(3 * t) + 0.3 * t * std::pow(h, p));
  }
  return values;
}

void expect_index_of(double p, double h, OfThree of) {
  const double fine = of == OfThree::finest ? h : h / 4;
  const MeshIndex index = mesh_index(made(fine, p), made(2 * fine, p), made(4 * fine, p), of);
  EXPECT_NEAR(index.order, p, 1e-6) << "h " << h;
  ASSERT_EQ(index.values.size(), 21U);
  for (int k = 0; k <= 20; ++k)
    EXPECT_NEAR(index.values[k], certain_factor * 0.3 * 0.1 * k * std::pow(h, p),
                1e-7 * std::pow(h, p) + 1e-13)
        << "order " << p << ", time " << 0.1 * k;
}

TEST(MeshIndex, IsTheSafetyFactorTimesTheErrorWhereAnOrderHolds) {
  for (const OfThree of : {OfThree::finest, OfThree::coarsest})
    for (const double p : {1.2, 2.0, 3.3, 4.0}) expect_index_of(p, 0.125, of);
}

TEST(MeshIndex, OfAnOrderThatElementsDoNotHaveThereIsNone) {
  for (const double p : {0.1, 0.9, 4.6, 6.0}) {
    const MeshIndex index = mesh_index(made(0.25, p), made(0.5, p), made(1, p), OfThree::finest);
    EXPECT_NEAR(index.order, p, 1e-6);
    EXPECT_FALSE(is_possible_order(index.order));
    EXPECT_TRUE(index.values.empty()) << "order " << p;
  }
}

TEST(MeshIndex, AnOrderAboveThatOfTheElementsCountsAsThat) {
  const MeshIndex index = mesh_index(made(0.25, 4.4), made(0.5, 4.4), made(1, 4.4), OfThree::finest);
  const double change = 0.3 * 2 * (std::pow(0.5, 4.4) - std::pow(0.25, 4.4));
  EXPECT_NEAR(index.values.back(), certain_factor * change / (std::pow(2, 4) - 1), 1e-12);
}

TEST(TwoRunBound, IsThreeTimesTheGreatestChangeUpToThen) {
  EXPECT_EQ(two_run_bound({0, 1, 2}, {0, -1, 2}), (std::vector<double>{0, 6, 6}));
}

TEST(MeshIndex, NothingIsKnownWhereChangesDoNotFall) {
  const std::vector<double> zero(5, 0.0), one(5, 1.0), two(5, 2.0), half(5, 0.5);
  for (const auto& [fine, medium, coarse] : {std::tuple(zero, one, two), std::tuple(zero, two, half)}) {
    const MeshIndex index = mesh_index(fine, medium, coarse, OfThree::finest);
    EXPECT_EQ(index.order, -1);
    EXPECT_TRUE(index.values.empty()) << "an index of 0 would claim certainty";
  }
}

TEST(MeshIndex, DoesNotFallWhereCurvesCross) {
  const std::vector<double> fine{0, 0, 0}, medium{0, 0.1, 0}, coarse{0, 0.5, 0};
  const MeshIndex index = mesh_index(fine, medium, coarse, OfThree::finest);
  ASSERT_EQ(index.values.size(), 3U);
  EXPECT_EQ(index.values[0], 0);
  EXPECT_GT(index.values[1], 0);
  EXPECT_EQ(index.values[2], index.values[1]);
}

TEST(TwoRunIndex, IsThreeTimesTheErrorOfAMethodOfThatOrder) {
  for (const double p : {1.0, 2.0, 4.0}) {
    const std::vector<double> index = two_run_index(made(0.1, p), made(0.05, p), 2, p);
    for (int k = 0; k <= 20; ++k)
      EXPECT_NEAR(index[k], 3 * 0.3 * 0.1 * k * std::pow(0.1, p), 1e-13) << "order " << p;
  }
}

}  // namespace mesh_index_test
}  // namespace plumb
