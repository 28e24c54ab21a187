#include "engine/study/stability/critical_step.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace critical_step_test {

std::string table_row(const CriticalStep& step, double f) {
  return fmt::format(
      "{} f = {:g}, {} elements: seen {:.4g} to {:.4g} s ({} beyond), predicted {:.4g} s at the "
      "start, {:.4g} s at the worst",
      step.method.name, f, step.elements, step.stable, step.unstable, word(step.beyond),
      step.predicted.at_start, step.predicted.at_worst);
}

/// Bisects on meshes of 4 to 32 elements and holds what is seen against the prediction.
void expect_predicted_limit(const std::string& name, double f) {
  for (const int elements : {4, 8, 16, 32}) {
    Case spec = pendulum(f, elements);
    // Vibrations are as fast as 1/f, and stiff cables have as many of them as soft ones.
    spec.time.end = std::min(spec.time.end, 0.4 * f);
    const CriticalStep step = critical_step(spec, plain_method(*find_method(name)));
    EXPECT_EQ(step.limit_kind, LimitKind::vibration);
    EXPECT_EQ(step.elements, elements);
    EXPECT_GT(step.stable, 0) << table_row(step, f);
    EXPECT_GT(step.unstable, step.stable) << table_row(step, f);
    EXPECT_LE(step.unstable, (1 + critical_step_share) * step.stable) << table_row(step, f);
    EXPECT_LE(step.predicted.at_worst, step.predicted.at_start) << table_row(step, f);
    constexpr double share = 0.05;
    EXPECT_NEAR(step.stable, step.predicted.at_worst, share * step.predicted.at_worst) << table_row(step, f);
    EXPECT_NEAR(step.unstable, step.predicted.at_worst, share * step.predicted.at_worst)
        << table_row(step, f);
    EXPECT_TRUE(step.beyond == Outcome::unstable || step.beyond == Outcome::diverged ||
                step.beyond == Outcome::singular)
        << table_row(step, f);
  }
}

class CriticalStepOf : public testing::TestWithParam<double> {};

TEST_P(CriticalStepOf, VelocityVerletIsThePredictedOne) {
  expect_predicted_limit("velocity-verlet", GetParam());
}

TEST_P(CriticalStepOf, Rk4IsThePredictedOne) {
  expect_predicted_limit("rk4", GetParam());
}

INSTANTIATE_TEST_SUITE_P(Pendulum, CriticalStepOf, testing::Values(1, 2, 5, 10, 20));

// ω_max = 9.548 c/l, so 7.40e-4 s and 1.047e-3 s.
TEST(CriticalStep, IsPredictedForTheStraightStartByTheClosedForm) {
  EXPECT_NEAR(critical_step(pendulum(5, 4), plain_method(*find_method("velocity-verlet"))).predicted.at_start,
              7.40e-4, 1e-6);
  EXPECT_NEAR(critical_step(pendulum(5, 4), plain_method(*find_method("rk4"))).predicted.at_start, 1.047e-3,
              1e-6);
}

// Beyond 1.047e-3 s the run stays finite for a while: plausible, and wrong by half a metre.
TEST(CriticalStep, IsNotTakenInByARunThatStaysFinite) {
  const Trajectory wrong = run(pendulum(5, 4), method("rk4", 1.08e-3), {2, 0.02});
  const Trajectory exact = run(pendulum(5, 4), method("runge-kutta-nystrom", {}, 1e-10), {2, 0.02});
  ASSERT_EQ(wrong.outcome, Outcome::completed) << wrong.message;
  EXPECT_GT(tip_distance(wrong, exact), 0.1);
  EXPECT_LT(critical_step(pendulum(5, 4), plain_method(*find_method("rk4"))).unstable, 1.08e-3);
}

TEST(CriticalStep, OfAnImplicitMethodIsWhereItsRunsEnd) {
  Case spec = pendulum(1, 4);
  const CriticalStep step = critical_step(spec, plain_method(*find_method("trapezoidal")));
  EXPECT_EQ(step.limit_kind, LimitKind::contraction);
  EXPECT_EQ(step.predicted.at_start, -1);
  ASSERT_GT(step.unstable, 0);
  spec.method = step.method;
  spec.method.step = step.stable;
  EXPECT_EQ(integrate(spec).outcome, Outcome::completed);
  spec.method.step = step.unstable;
  EXPECT_EQ(integrate(spec).outcome, step.beyond);
}

TEST(CriticalStep, IsNotFoundWhereEveryStepServes) {
  Case spec = pendulum(20, 4);
  spec.time = {0.2, 0.02};
  const CriticalStep step = critical_step(spec, plain_method(*find_method("implicit-euler")));
  // An eighth of the run, less the stride of the search.
  EXPECT_GT(step.stable, 0.2 / 8 / 1.3);
  EXPECT_EQ(step.unstable, -1);
  EXPECT_EQ(step.beyond, Outcome::not_run);
}

TEST(CriticalStep, IsRefusedForAMethodThatTakesNoStep) {
  EXPECT_THROW(critical_step(pendulum(5, 4), plain_method(*find_method("cvode-bdf"))), std::invalid_argument);
}

TEST(CriticalStep, IsLeftOpenWhereTheTimeIsOver) {
  const CriticalStep step = critical_step(pendulum(5, 4), plain_method(*find_method("rk4")), 1e-9);
  EXPECT_EQ(step.stable, -1);
  EXPECT_EQ(step.unstable, -1);
}

}  // namespace critical_step_test
}  // namespace plumb
