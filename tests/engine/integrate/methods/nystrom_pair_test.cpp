#include "engine/integrate/methods/nystrom_pair.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace nystrom_pair_test {

using Pair = NystromPair;

double sum(const Pair::Row& weights, int power_of_c) {
  double total = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) total += weights[i] * std::pow(Pair::c[i], power_of_c);
  return total;
}

TEST(NystromPair, StagesAreOfSecondOrder) {
  for (std::size_t i = 0; i < Pair::a.size(); ++i)
    EXPECT_NEAR(sum(Pair::a[i], 0), 0.5 * Pair::c[i] * Pair::c[i], 1e-14) << "stage " << i + 1;
}

// The quadrature conditions: Σ b cᵏ = 1/((k+1)(k+2)) up to k = p − 2 and Σ b' cᵏ = 1/(k+1) up to k = p − 1.
TEST(NystromPair, WeightsIntegrateAsTheirOrdersSayAndNoFurther) {
  for (int k = 0; k <= 6; ++k) EXPECT_NEAR(sum(Pair::b, k), 1.0 / ((k + 1) * (k + 2)), 1e-15) << "b, c^" << k;
  for (int k = 0; k <= 7; ++k) EXPECT_NEAR(sum(Pair::velocity, k), 1.0 / (k + 1), 1e-15) << "b', c^" << k;
  for (int k = 0; k <= 4; ++k)
    EXPECT_NEAR(sum(Pair::lower, k), 1.0 / ((k + 1) * (k + 2)), 1e-14) << "lower, c^" << k;
  EXPECT_GT(std::abs(sum(Pair::lower, 6) - 1.0 / 56), 1e-6) << "the embedded formula is not of order 8";
}

TEST(NystromPair, TheLastStageIsTheFirstOfTheNextStep) {
  EXPECT_EQ(Pair::a.back(), Pair::b);
  EXPECT_EQ(Pair::c.back(), 1);
}

}  // namespace nystrom_pair_test
}  // namespace plumb
