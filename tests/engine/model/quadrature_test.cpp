#include "engine/model/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace plumb {
namespace quadrature_test {

double integral_of_power(std::span<const QuadraturePoint> rule, int power) {
  double sum = 0;
  for (const QuadraturePoint& p : rule) sum += p.weight * std::pow(p.x, power);
  return sum;
}

/// Exact up to the degree, and wrong beyond it: a rule of a higher degree under this name would be found too.
void expect_degree(std::span<const QuadraturePoint> rule, int degree) {
  for (int power = 0; power <= degree; ++power)
    EXPECT_NEAR(integral_of_power(rule, power), 1.0 / (power + 1), 1e-15) << "x^" << power;
  EXPECT_GT(std::abs(integral_of_power(rule, degree + 1) - 1.0 / (degree + 2)), 1e-7) << "x^" << degree + 1;
}

TEST(Quadrature, GaussRulesHaveDegreeTwiceTheirPointsLessOne) {
  expect_degree(gauss_rule(2), 3);
  expect_degree(gauss_rule(3), 5);
  expect_degree(gauss_rule(5), 9);
}

TEST(Quadrature, LobattoRuleHasDegreeThree) {
  expect_degree(lobatto_rule(), 3);
}

TEST(Quadrature, OtherNumbersOfPointsAreRefused) {
  EXPECT_THROW(gauss_rule(4), std::invalid_argument);
}

}  // namespace quadrature_test
}  // namespace plumb
