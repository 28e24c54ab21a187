#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace tolerance_test {

const TimeSpec half_second{0.5, 0.05};

struct Controlled {
  std::string name;
  std::string key;
  double value = 0;
};

void PrintTo(const Controlled& with, std::ostream* out) {
  *out << with.name << ", " << with.key << " = " << with.value;
}

class ErrorControl : public testing::TestWithParam<Controlled> {};

// The slope is 1 where a method keeps the local error to the tolerance a unit step; multistep methods, which
// keep it a step, lose order/(order + 1) of it and more as they change their order.
TEST_P(ErrorControl, FollowsTheToleranceFromBothSides) {
  static const Trajectory reference = run(pendulum(5, 4), method("arkode-erk", {}, 1e-13), half_second);
  std::string seen;
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0, count = 0;
  for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
    MethodSpec with = method(GetParam().name, {}, tolerance);
    with.parameters[GetParam().key] = GetParam().value;
    const Trajectory trajectory = run(pendulum(5, 4), with, half_second);
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    const double error = tip_distance(trajectory, reference);
    const double x = std::log10(tolerance), y = std::log10(error);
    sum_x += x, sum_y += y, sum_xx += x * x, sum_xy += x * y, ++count;
    seen += fmt::format("rtol {:g}: tip error {:.3g} m\n", tolerance, error);
    EXPECT_LE(error, 300 * tolerance) << seen;
  }
  const double slope = (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
  EXPECT_GE(slope, 0.45) << seen;
  EXPECT_LE(slope, 1.35) << seen;
  RecordProperty("slope", fmt::format("{:.3f}", slope));
}

INSTANTIATE_TEST_SUITE_P(
    All, ErrorControl,
    testing::Values(Controlled{"arkode-erk", "order", 3}, Controlled{"arkode-erk", "order", 4},
                    Controlled{"arkode-erk", "order", 5}, Controlled{"arkode-erk", "order", 6},
                    Controlled{"arkode-erk", "order", 7}, Controlled{"arkode-erk", "order", 8},
                    Controlled{"arkode-dirk", "order", 3}, Controlled{"arkode-dirk", "order", 4},
                    Controlled{"arkode-dirk", "order", 5}, Controlled{"cvode-adams", "max_order", 12},
                    Controlled{"cvode-adams", "max_order", 5}, Controlled{"cvode-bdf", "max_order", 5},
                    Controlled{"ida", "max_order", 5}),
    [](const auto& parameter) {
      std::string name = parameter.param.name + fmt::format("_{:g}", parameter.param.value);
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

// Errors of many steps add up, and must not add up to more than was asked for.
TEST(ErrorControl, OfMethodsOfLowOrderKeepsTheWholeRunWithinItsTolerance) {
  static const Trajectory reference = run(pendulum(5, 4), method("arkode-erk", {}, 1e-13), half_second);
  for (const MethodInfo& info : method_infos()) {
    if (info.family != MethodFamily::structural || !info.takes_tolerances) continue;
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
      if (tolerance < 0.01 * info.rtol) continue;  // too much work for a test
      const Trajectory trajectory = run(pendulum(5, 4), method(info.name, {}, tolerance), half_second);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << info.name << ": " << trajectory.message;
      const double error = tip_distance(trajectory, reference);
      EXPECT_LE(error, 10 * tolerance) << fmt::format("{}, rtol {:g}: {:.3g} m", info.name, tolerance, error);
    }
  }
}

TEST(ErrorControl, RefusesWhatWouldTakeTooManyStepsAndNamesTheToleranceThatWouldNot) {
  const Trajectory refused = run(pendulum(5, 4), method("implicit-euler", {}, 1e-9), half_second);
  EXPECT_EQ(refused.outcome, Outcome::no_convergence) << refused.message;
  EXPECT_NE(refused.message.find("steps, more than 1e+07; from about "), refused.message.npos)
      << refused.message;
  EXPECT_LT(refused.counters.steps, 10000) << "it went on for long before it was refused";
}

TEST(ErrorControl, RefusesNothingForACautiousFirstStep) {
  constexpr double short_time = 0.01;
  for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
    const Trajectory seen =
        run(pendulum(5, 64), method("runge-kutta-nystrom", {}, tolerance), {short_time, short_time});
    EXPECT_EQ(seen.outcome, Outcome::completed) << tolerance << ": " << seen.message;
  }
}

TEST(ErrorControl, OfAdamsFormulasUsesNoMatrixAndFewForcesAStep) {
  const Trajectory seen = run(pendulum(5, 4), method("cvode-adams", {}, 1e-8), half_second);
  EXPECT_EQ(seen.counters.tangent_evaluations, 0);
  EXPECT_EQ(seen.counters.factorizations, 0);
  EXPECT_LT(seen.counters.force_evaluations, 2.5 * static_cast<double>(seen.counters.steps));
}

// A lower highest order needs more steps for the same tolerance: the parameter reaches the library.
TEST(ErrorControl, OfMultistepMethodsNeedsMoreStepsWithALowerHighestOrder) {
  for (const char* name : {"cvode-adams", "cvode-bdf", "ida"}) {
    long previous = 0;
    for (const double order : {5, 3, 2}) {
      MethodSpec with = method(name, {}, 1e-7);
      with.parameters["max_order"] = order;
      const long steps = run(pendulum(20, 2), with, {0.2, 0.2}).counters.steps;
      EXPECT_GT(steps, previous) << name << ", order " << order;
      previous = steps;
    }
  }
}

}  // namespace tolerance_test
}  // namespace plumb
