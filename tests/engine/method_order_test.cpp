#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace {

const TimeSpec half_second{0.5, 0.02};

/// The four-element pendulum at f = 5 integrated far more finely than anything compared with it.
const Trajectory& reference() {
  static const Trajectory trajectory = run(pendulum(5, 4), method("arkode-erk", {}, 1e-12), half_second);
  return trajectory;
}

/// Halves the step twice and holds the observed order against the stated one from both sides.
void expect_order(const std::string& name, double coarsest, double order) {
  std::string seen = name;
  double previous = 0;
  for (const double h : {coarsest, coarsest / 2, coarsest / 4}) {
    const Trajectory trajectory = run(pendulum(5, 4), method(name, h), half_second);
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    const double error = tip_distance(trajectory, reference());
    seen += fmt::format("\n  h = {:g}: tip error {:.4g} m", h, error);
    if (previous > 0) {
      const double observed = std::log2(previous / error);
      seen += fmt::format(", order {:.3f}", observed);
      EXPECT_NEAR(observed, order, 0.15) << seen;
    }
    previous = error;
  }
}

TEST(MethodOrder, LinearlyImplicitEulerIsOfOrderOne) {
  expect_order("linearly-implicit-euler", 1e-4, 1);
}

TEST(MethodOrder, GeneralizedAlphaIsOfOrderTwo) {
  expect_order("generalized-alpha", 2e-3, 2);
}

TEST(MethodOrder, Rk4IsOfOrderFour) {
  expect_order("rk4", 8e-5, 4);
}

TEST(MethodOrder, ErrorControlledMethodsKeepTheirToleranceToAFactor) {
  for (const char* name : {"cvode-bdf", "arkode-erk"})
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      const double error =
          tip_distance(run(pendulum(5, 4), method(name, {}, tolerance), half_second), reference());
      EXPECT_LE(error, 2e3 * tolerance) << name << " at rtol = " << tolerance;
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

}  // namespace
}  // namespace plumb
