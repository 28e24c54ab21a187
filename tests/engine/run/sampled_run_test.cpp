#include "engine/run/sampled_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/report/made_run.h"

namespace plumb {
namespace sampled_run_test {

std::vector<double> every(double interval, int count) {
  std::vector<double> times;
  for (int k = 0; k < count; ++k) times.push_back(k * interval);
  return times;
}

/// An external run whose tip.y is t⁴, whose fourth divided difference is 1 everywhere.
GivenRun quartic(const std::vector<double>& times) {
  GivenRun run;
  run.times = times;
  run.columns = {{"tip.y", "tip.y", "m", "m", {}}};
  for (const double t : times) run.columns[0].values.push_back(t * t * t * t);
  return run;
}

TEST(KnownTime, IsAnOutputButForRoundingAndNothingOutside) {
  const std::vector<double> outputs{0, 0.1, 0.2, 0.3};
  const auto at = [&](double t) { return known_time(outputs, t); };
  EXPECT_TRUE(at(0.1 + 1e-16)->output);
  EXPECT_EQ(at(0.1 + 1e-16)->time, 0.1) << "the time is as the run has it";
  EXPECT_TRUE(at(0.3 + 2e-10)->output) << "a billionth of the last";
  EXPECT_FALSE(at(0.1 + 1e-9)->output);
  EXPECT_EQ(at(0.14)->before, 1U);
  EXPECT_DOUBLE_EQ(at(0.14)->distance, 0.04);
  EXPECT_DOUBLE_EQ(at(0.16)->distance, 0.04);
  EXPECT_FALSE(at(0.3 + 1e-9)) << "nothing is extrapolated";
  EXPECT_FALSE(at(-1e-9));
  EXPECT_FALSE(at(std::nan("")));
  EXPECT_FALSE(known_time({}, 0));
  EXPECT_TRUE(known_time({2}, 2)->output);
  EXPECT_FALSE(known_time({2}, 1));
}

TEST(KnownTime, ADistantLastOutputMakesNoOtherTimeTheSame) {
  const std::vector<double> outputs{0, 0.1, 0.2, 1e12};
  EXPECT_FALSE(known_time(outputs, 0.15)->output);
  EXPECT_FALSE(known_time(outputs, 0.101)->output);
}

TEST(TriedOutputs, AreTwoOnEitherSideButNeverTheEnds) {
  const std::vector<double> outputs = every(1, 9);
  const auto tried = [&](double t) { return tried_outputs(outputs, *known_time(outputs, t)); };
  using Places = std::vector<std::size_t>;
  EXPECT_EQ(tried(0.5), (Places{1, 2}));
  EXPECT_EQ(tried(1.5), (Places{1, 2, 3}));
  EXPECT_EQ(tried(3.5), (Places{2, 3, 4, 5}));
  EXPECT_EQ(tried(6.5), (Places{5, 6, 7}));
  EXPECT_EQ(tried(7.5), (Places{6, 7}));
  EXPECT_EQ(tried(3), Places{});
}

TEST(TriedDistance, IsThatToTheNearestOutputThatIsKept) {
  const auto tried = [](const std::vector<double>& outputs, double t) {
    return tried_distance(outputs, *known_time(outputs, t));
  };
  EXPECT_DOUBLE_EQ(tried(every(0.25, 9), 0.3), 0.25);
  EXPECT_EQ(tried(every(0.25, 9), 0.5), 0) << "an output is not interpolated";
  EXPECT_DOUBLE_EQ(tried({0, 1, 2, 3, 5, 6, 7, 8}, 4), 1) << "the middle of a gap of two";
  EXPECT_DOUBLE_EQ(tried({0, 1, 2, 3, 7, 8, 9, 10}, 5), 1) << "the gap itself was never tried";
  EXPECT_DOUBLE_EQ(tried({0, 1, 2, 3, 5, 8, 20, 40, 80}, 4), 2) << "only the outputs next to it count";
  EXPECT_EQ(tried(every(0.25, fewest_outputs - 1), 0.3), 0) << "too few to leave half of them out";
}

TEST(SampledRun, TheErrorOfAQuarticIsTheProductOfTheDistancesWhenEverySecondTimeIsLeftOut) {
  const double h = 0.25;
  const SampledRun sampled = sample(quartic(every(h, 17)), {2, 2.125, 9});
  ASSERT_EQ(sampled.rows, (std::vector<std::size_t>{0, 1})) << "9 s is outside";
  const std::vector<double>& errors = sampled.errors.find("tip.y")->values;
  EXPECT_EQ(errors[0], 0) << "an output is what it is";
  EXPECT_NEAR(errors[1], 9 * h * h * h * h, 1e-12) << "h · h · 3h · 3h";
  const double real = std::abs(sampled.values.find("tip.y")->values[1] - std::pow(2.125, 4));
  EXPECT_NEAR(real, 9.0 / 16 * h * h * h * h, 1e-12) << "sixteen times less, as the gaps are half as long";
}

TEST(SampledRun, AnErrorThatCannotBeToldIsNoNumber) {
  const auto error = [](const std::vector<double>& times, double t) {
    return sample(quartic(times), {t}).errors.find("tip.y")->values.at(0);
  };
  EXPECT_TRUE(std::isnan(error({0, 2}, 0.5)));
  EXPECT_TRUE(std::isnan(error(every(0.25, 7), 0.3)));
  EXPECT_FALSE(std::isnan(error(every(0.25, 8), 0.3)));
  EXPECT_FALSE(std::isnan(error({0, 1, 2, 3, 5, 6, 7, 8}, 4)));
  EXPECT_TRUE(std::isnan(error({0, 1, 2, 3, 6, 7, 8, 9}, 4.5)));
  EXPECT_FALSE(std::isnan(error({0, 1, 2, 3, 6, 7, 8, 9}, 4)));
  EXPECT_EQ(error({0, 2}, 2), 0);
}

TEST(SampledRun, ARunOfPlumbsOwnIsTriedByItsStates) {
  plumb::Run run = run_with("a");
  const double h = 0.25;
  run.trajectory.times = every(h, 9);
  const Eigen::VectorXd rest = run.trajectory.q.front();
  run.trajectory.q.assign(9, rest);
  run.trajectory.v.assign(9, Eigen::VectorXd::Zero(12));
  for (std::size_t k = 0; k < 9; ++k) {
    const double t = run.trajectory.times[k];
    run.trajectory.q[k][7] = t * t * t * t;
    run.trajectory.v[k][7] = 4 * t * t * t;
  }
  const SampledRun sampled = sample(run.loaded.spec, run.trajectory, {1.0, 1.125});
  const std::vector<double>& errors = sampled.errors.find("tip.y")->values;
  EXPECT_EQ(errors[0], 0);
  EXPECT_NEAR(errors[1], h * h * h * h, 1e-12) << "h² · h² of a quartic by cubic Hermite polynomials";

  // Equilibria have no rates, so that nothing tells what lies between two of them.
  run.loaded.spec.method.name = "statics";
  const SampledRun equilibria = sample(run.loaded.spec, run.trajectory, {1.0, 1.125});
  EXPECT_EQ(equilibria.errors.find("tip.y")->values[0], 0);
  EXPECT_TRUE(std::isnan(equilibria.errors.find("tip.y")->values[1]));
  EXPECT_TRUE(equilibria.between_is_unknown);
}

TEST(SampledRun, BearableIsATenthOfTheToleranceAndNoMore) {
  EXPECT_TRUE(bearable(0, 1e-9));
  EXPECT_TRUE(bearable(0.1, 1));
  EXPECT_FALSE(bearable(0.1001, 1));
  EXPECT_FALSE(bearable(std::nan(""), 1));
  EXPECT_FALSE(bearable(0, std::nan("")));
  EXPECT_TRUE(bearable(1e9, std::numeric_limits<double>::infinity())) << "no tolerance";
  EXPECT_FALSE(bearable(std::nan(""), std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(bearable(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()));
}

}  // namespace sampled_run_test
}  // namespace plumb
