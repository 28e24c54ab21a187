#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace arkode_order_test {

// At f = 20 the axial motion is slow enough for the pairs of high order to show their order above round-off.
constexpr double softness = 20;
const TimeSpec half_second{0.5, 0.1};

struct Pair {
  const char* name;
  int order;
  double step;  // s; from here to its half the order is looked for
};

void PrintTo(const Pair& pair, std::ostream* out) {
  *out << pair.name << " of order " << pair.order;
}

double error(const Pair& pair, double step) {
  static const Trajectory reference =
      run(pendulum(softness, 4), method("arkode-erk", {}, 1e-13), half_second);
  MethodSpec with = method(pair.name, step);
  with.parameters["order"] = pair.order;
  if (with.parameters.contains("newton_tolerance")) with.parameters["newton_tolerance"] = 1e-14;
  const Trajectory seen = run(pendulum(softness, 4), with, half_second);
  EXPECT_EQ(seen.outcome, Outcome::completed) << seen.message;
  return tip_distance(seen, reference);
}

class ArkodePair : public testing::TestWithParam<Pair> {};

TEST_P(ArkodePair, IsOfTheOrderThatItIsAskedFor) {
  const double h = GetParam().step, coarse = error(GetParam(), h), fine = error(GetParam(), h / 2);
  const double observed = std::log2(coarse / fine);
  const std::string seen = fmt::format(
      "tip error {:.4g} m at h = {:g} s, {:.4g} m at half of it: order {:.3f}", coarse, h, fine, observed);
  EXPECT_NEAR(observed, GetParam().order, 0.45) << seen;
  RecordProperty("seen", seen);
}

INSTANTIATE_TEST_SUITE_P(All, ArkodePair,
                         testing::Values(Pair{"arkode-erk", 2, 2.5e-4}, Pair{"arkode-erk", 3, 2.5e-4},
                                         Pair{"arkode-erk", 4, 5e-4}, Pair{"arkode-erk", 5, 1e-3},
                                         Pair{"arkode-erk", 6, 1e-3}, Pair{"arkode-erk", 7, 1e-3},
                                         Pair{"arkode-erk", 8, 2e-3}, Pair{"arkode-dirk", 2, 1e-3},
                                         Pair{"arkode-dirk", 3, 2.5e-4}, Pair{"arkode-dirk", 4, 5e-4},
                                         Pair{"arkode-dirk", 5, 1e-3}),
                         [](const auto& parameter) {
                           return (std::string(parameter.param.name) == "arkode-erk" ? "erk" : "dirk") +
                                  std::to_string(parameter.param.order);
                         });

// A last stage that lies at the end of the step but is not its result must not be taken for the first of the
// next one: that would save an evaluation a step, and cost order.
TEST(ArkodeErk, EvaluatesAsManyForcesAsItsPairsHaveStages) {
  const int stages[] = {2, 3, 5, 6, 8, 13, 13};
  for (int order = 2; order <= 8; ++order) {
    MethodSpec with = method("arkode-erk", 1e-4);
    with.parameters["order"] = order;
    const Trajectory seen = run(pendulum(softness, 4), with, {0.01, 0.01});
    EXPECT_EQ(seen.counters.steps, 100) << "order " << order;
    EXPECT_EQ(seen.counters.force_evaluations, 100 * stages[order - 2] + 1) << "order " << order;
  }
}

TEST(ArkodeFixedStep, EndsOnMultiplesOfTheStepAndShortensOnlyTheLast) {
  for (const char* name : {"arkode-erk", "arkode-dirk"}) {
    const Trajectory seen = run(pendulum(5, 4), method(name, 3e-4), {0.1, 0.01});
    EXPECT_EQ(seen.counters.steps, 334) << name;
    EXPECT_EQ(seen.end_time, 0.1) << name;
    EXPECT_GT(seen.interpolated_outputs, 0) << name;
    const Trajectory exact = run(pendulum(5, 4), method("arkode-erk", {}, 1e-12), {0.1, 0.01});
    EXPECT_LE(tip_distance(seen, exact), 1e-8) << name;
  }
}

TEST(ArkodeDirk, NewtonThatIsCutOffIsNotAccepted) {
  MethodSpec with = method("arkode-dirk", 2e-3);
  with.parameters["newton_iterations"] = 1;
  const Trajectory seen = run(pendulum(5, 4), with, {0.5, 0.1});
  EXPECT_EQ(seen.outcome, Outcome::no_convergence) << seen.message;
  EXPECT_NE(seen.message.find("arkode-dirk ended at t = "), std::string::npos) << seen.message;
}

// With the library's own settings the steps of this order shrink to 1e-14 s here.
TEST(ArkodeDirk, OfOrderFourDoesNotStallAtTightTolerances) {
  MethodSpec with = method("arkode-dirk", {}, 1e-10);
  with.parameters["order"] = 4;
  const Trajectory seen = run(pendulum(5, 4), with, {0.05, 0.05});
  EXPECT_EQ(seen.outcome, Outcome::completed) << seen.message;
  EXPECT_LT(seen.counters.steps, 2000);
}

}  // namespace arkode_order_test
}  // namespace plumb
