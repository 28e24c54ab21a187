#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace method_order_test {

const TimeSpec half_second{0.5, 0.02};

/// The four-element pendulum at f = 5 integrated far more finely than anything compared with it.
const Trajectory& reference() {
  static const Trajectory trajectory = run(pendulum(5, 4), method("runge-kutta-nystrom", 2e-4), half_second);
  return trajectory;
}

/// Halves the step twice and holds the observed order against the stated one from both sides.
void expect_order(const std::string& name, double coarsest, double order, double tolerance = 0.15,
                  const std::map<std::string, double>& parameters = {}) {
  std::string seen = name;
  double previous = 0;
  for (const double h : {coarsest, coarsest / 2, coarsest / 4}) {
    MethodSpec with = method(name, h);
    for (const auto& [key, value] : parameters) with.parameters[key] = value;
    const Trajectory trajectory = run(pendulum(5, 4), with, half_second);
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    const double error = tip_distance(trajectory, reference());
    seen += fmt::format("\n  h = {:g}: tip error {:.4g} m", h, error);
    if (previous > 0) {
      const double observed = std::log2(previous / error);
      seen += fmt::format(", order {:.3f}", observed);
      EXPECT_NEAR(observed, order, tolerance) << seen;
    }
    previous = error;
  }
}

TEST(MethodOrder, LinearlyImplicitEulerIsOfOrderOne) {
  expect_order("linearly-implicit-euler", 1e-4, 1);
}

TEST(MethodOrder, ImplicitEulerIsOfOrderOne) {
  expect_order("implicit-euler", 2e-4, 1);
}

TEST(MethodOrder, GeneralizedAlphaIsOfOrderTwoAtEveryDamping) {
  for (const double rho : {1.0, 0.8, 0.5, 0.0})
    for (const double mean : {0.0, 1.0})
      expect_order("generalized-alpha", 5e-4, 2, 0.15, {{"spectral_radius", rho}, {"mean_forces", mean}});
}

// A start from any other than the true acceleration, or old forces left out, would show as order one.
TEST(MethodOrder, HhtIsOfOrderTwoAtEveryDamping) {
  for (const double alpha : {-1.0 / 3, -0.2, -0.05, 0.0})
    expect_order("hht", 5e-4, 2, 0.15, {{"alpha", alpha}});
}

TEST(MethodOrder, TrapezoidalRuleMidpointRuleAndEnergyMomentumAreOfOrderTwo) {
  for (const char* name : {"trapezoidal", "implicit-midpoint", "energy-momentum"})
    expect_order(name, 5e-4, 2);
}

TEST(MethodOrder, VelocityVerletIsOfOrderTwo) {
  expect_order("velocity-verlet", 4e-4, 2);
}

TEST(MethodOrder, GaussIsOfOrderSix) {
  expect_order("gauss", 5e-4, 6, 0.6);
}

TEST(MethodOrder, RungeKuttaNystromIsOfOrderEight) {
  expect_order("runge-kutta-nystrom", 1.25e-3, 8, 0.6);
}

TEST(MethodOrder, Rk4IsOfOrderFour) {
  expect_order("rk4", 8e-5, 4);
}

TEST(MethodOrder, ErrorControlledMethodsKeepTheirToleranceToAFactor) {
  for (const char* name : {"cvode-bdf", "arkode-erk", "runge-kutta-nystrom"})
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      const double error =
          tip_distance(run(pendulum(5, 4), method(name, {}, tolerance), half_second), reference());
      EXPECT_LE(error, 2e3 * tolerance) << name << " at rtol = " << tolerance;
    }
}

// Held to the tolerance over the whole run, errors shrink as it does.
TEST(MethodOrder, ControlledStepsOfStructuralMethodsKeepTheirTolerance) {
  for (const char* name :
       {"trapezoidal", "hht", "generalized-alpha", "implicit-midpoint", "energy-momentum"}) {
    std::string seen = name;
    double coarse = 0;
    for (const double tolerance : {1e-4, 1e-6}) {
      const Trajectory trajectory = run(pendulum(5, 4), method(name, {}, tolerance), half_second);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
      const double error = tip_distance(trajectory, reference());
      seen += fmt::format("\n  rtol {:g}: tip error {:.3g} m in {} steps", tolerance, error,
                          trajectory.counters.steps);
      EXPECT_LE(error, 10 * tolerance) << seen;
      if (coarse > 0) {
        EXPECT_NEAR(std::log10(coarse / error), 2, 0.3) << seen;
      }
      coarse = error;
    }
  }
}

// The order that the pendulum's tip shows between 8 and 32 elements against 64; cubic elements have 4 at
// most.
TEST(MethodOrder, TheMeshIsOfOrderThreeOrMoreInTipPosition) {
  const auto at = [](int elements) { return run(pendulum(5, elements), method("rk4", 4e-5), half_second); };
  const Trajectory fine = at(64);
  const double coarse_error = tip_distance(at(8), fine), fine_error = tip_distance(at(32), fine);
  const double observed = std::log2(coarse_error / fine_error) / 2;
  EXPECT_GE(observed, 3 - 0.15) << coarse_error << " m with 8 elements, " << fine_error << " m with 32";
  EXPECT_LE(observed, 4 + 0.15) << coarse_error << " m with 8 elements, " << fine_error << " m with 32";
}

}  // namespace method_order_test
}  // namespace plumb
