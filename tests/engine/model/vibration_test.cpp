#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/base/dense.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace vibration_test {

/// Lowest circular frequencies (rad/s) of the straight, unstretched cable along one axis (0: axial, 1 and 2:
/// across).
std::vector<double> frequencies(const Case& spec, int axis) {
  const Cable cable(spec);
  BlockTridiagonal K(cable.nodes()), M(cable.nodes());
  cable.system(cable.start_q(spec.start), 0, 1, K);
  cable.system(cable.start_q(spec.start), 1, 0, M);
  std::vector<int> kept;
  for (int i = axis; i < cable.size(); i += 3) {
    Eigen::VectorXd unit = Eigen::VectorXd::Unit(cable.size(), i);
    cable.supports().apply(unit);
    if (unit[i] != 0) kept.push_back(i);
  }
  const Eigen::MatrixXd k = K.dense()(kept, kept), m = M.dense()(kept, kept);
  const Eigen::VectorXd values = symmetric_eigen(k, m).values;
  std::vector<double> result;
  for (const double value : values)
    if (value > 1e-6 * values.maxCoeff() * 1e-6) result.push_back(std::sqrt(std::max(0.0, value)));
  return result;
}

void expect_frequencies(const std::vector<double>& seen, const std::vector<double>& exact, double tolerance) {
  ASSERT_GE(seen.size(), exact.size());
  for (std::size_t k = 0; k < exact.size(); ++k)
    EXPECT_NEAR(seen[k], exact[k], tolerance * exact[k]) << "mode " << k + 1;
}

/// ω of a beam for the roots βL of its frequency equation.
std::vector<double> beam(const Case& spec, std::vector<double> roots) {
  const double EI = spec.cable.youngs_modulus * spec.cable.second_moment;
  const double rhoA = spec.cable.density * spec.cable.area;
  for (double& root : roots)
    root = root * root * std::sqrt(EI / rhoA) / (spec.cable.length * spec.cable.length);
  return roots;
}

// Closed forms: roots of tan βL = tanh βL for pinned-free, and of cos βL cosh βL = ∓1 for clamped-free and
// free-free.
TEST(Vibration, PinnedFreeBendingHasItsThreeLowestFrequencies) {
  const Case spec = pendulum(5, 24);
  const std::vector<double> exact{1.53774, 4.98327, 10.39720};
  expect_frequencies(beam(spec, {3.92660231205, 7.06858274563, 10.2101761228}), exact, 1e-5);
  // Without gravity and spin the rigid swing about the pin has frequency 0.
  std::vector<double> seen = frequencies(spec, 1);
  std::erase_if(seen, [](double w) { return w < 0.1; });
  expect_frequencies(seen, exact, 1e-4);
}

TEST(Vibration, FixedFreeAxialFrequenciesAreOddMultiplesOfTheQuarterWave) {
  expect_frequencies(frequencies(pendulum(5, 24), 0), {111.072, 333.216, 555.360}, 1e-4);
}

TEST(Vibration, ClampedFreeBendingFollowsTheBeamFormula) {
  Case spec = pendulum(5, 24);
  spec.supports.first = Support::clamped;
  expect_frequencies(frequencies(spec, 2), beam(spec, {1.87510406871, 4.69409113297, 7.85475743824}), 1e-4);
  expect_frequencies(frequencies(spec, 0), {111.072, 333.216, 555.360}, 1e-4);
}

TEST(Vibration, FreeFreeBendingFollowsTheBeamFormula) {
  Case spec = pendulum(5, 24);
  spec.supports.first = Support::free;
  std::vector<double> seen = frequencies(spec, 1);
  std::erase_if(seen, [](double w) { return w < 0.1; });
  expect_frequencies(seen, beam(spec, {4.73004074486, 7.85320462410}), 1e-4);
}

TEST(Vibration, ClampedLastEndIsTheMirrorOfAClampedFirst) {
  Case first = pendulum(5, 6), last = first;
  first.supports = {Support::clamped, Support::free};
  last.supports = {Support::free, Support::clamped};
  for (const int axis : {0, 1, 2})
    expect_frequencies(frequencies(last, axis), frequencies(first, axis), 1e-9);
}

}  // namespace vibration_test
}  // namespace plumb
