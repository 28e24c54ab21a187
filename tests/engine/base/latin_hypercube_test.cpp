#include "engine/base/latin_hypercube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumb {
namespace latin_hypercube_test {

TEST(LatinHypercube, HasOnePointInEveryStratumOfEveryDimension) {
  constexpr std::size_t samples = 37, dimensions = 3;
  const auto points = latin_hypercube(samples, dimensions, 5);
  ASSERT_EQ(points.size(), samples);
  for (std::size_t d = 0; d < dimensions; ++d) {
    std::set<int> strata;
    for (const auto& point : points) {
      ASSERT_GT(point[d], 0);
      ASSERT_LT(point[d], 1);
      strata.insert(static_cast<int>(point[d] * samples));
    }
    EXPECT_EQ(strata.size(), samples) << "dimension " << d;
  }
}

TEST(LatinHypercube, IsTheSameForASeedAndAnotherForAnother) {
  EXPECT_EQ(latin_hypercube(16, 2, 7), latin_hypercube(16, 2, 7));
  EXPECT_NE(latin_hypercube(16, 2, 7), latin_hypercube(16, 2, 8));
  // Recorded once: the same on every machine and with every standard library.
  EXPECT_DOUBLE_EQ(latin_hypercube(3, 2, 1)[0][0], 0.37880234545539909);
}

TEST(LatinHypercube, DimensionsAreNotInTheSameOrder) {
  const auto points = latin_hypercube(200, 2, 3);
  double correlation = 0;
  for (const auto& point : points) correlation += 12 * (point[0] - 0.5) * (point[1] - 0.5) / 200;
  EXPECT_LT(std::abs(correlation), 0.25);
}

TEST(LatinHypercube, RecoversMeanAndSpreadOfALinearModel) {
  // y = 3 + 2 x₁ + 0.5 x₂ with x₁ standard normal and x₂ uniform in ±1: variance 4 + 0.25/3.
  constexpr std::size_t samples = 200;
  double sum = 0, squares = 0;
  for (const auto& point : latin_hypercube(samples, 2, 11)) {
    const double y = 3 + 2 * normal_quantile(point[0]) + 0.5 * (2 * point[1] - 1);
    sum += y;
    squares += y * y;
  }
  const double mean = sum / samples, deviation = std::sqrt((squares - samples * mean * mean) / (samples - 1));
  EXPECT_NEAR(mean, 3, 0.01) << "simple random sampling would be off by some 0.14";
  EXPECT_NEAR(deviation, std::sqrt(4 + 0.25 / 3), 0.04);
}

TEST(NormalQuantile, IsTheInverseOfTheDistributionFunction) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.5), 0, 1e-15);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-13);
  for (const double p : {1e-300, 1e-12, 0.001, 0.2, 0.4999, 0.7, 0.999}) {
    const double below = 0.5 * std::erfc(-normal_quantile(p) / std::sqrt(2));
    EXPECT_NEAR(below / p, 1, 1e-11) << p;
  }
}

}  // namespace latin_hypercube_test
}  // namespace plumb
