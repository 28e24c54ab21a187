#include "engine/integrate/cost_forecast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "engine/integrate/integrate.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace cost_forecast_test {

constexpr double limit = 1;
constexpr int steps = 100000;

/// When a run of those costs is ended, s, and what it was foreseen to take; the whole of it and -1 where it
/// is not. `cost`: s for all of the run, were all of it as where this share of it is done.
struct Ending {
  double at = 0;
  double foreseen = -1;
};
Ending ending(const std::function<double(double)>& cost) {
  CostForecast forecast(limit);
  double seconds = 0;
  for (int k = 0; k < steps; ++k) {
    seconds += cost(1.0 * k / steps) / steps;
    if (const auto foreseen = forecast.too_long(1.0 * (k + 1) / steps, seconds, 1))
      return {seconds, *foreseen};
  }
  return {seconds};
}

TEST(CostForecast, EndsARunThatWouldTakeLongAfterATenthOfItsLimit) {
  const Ending found = ending([](double) { return 5.0; });
  EXPECT_NEAR(found.foreseen, 5, 0.01);
  EXPECT_NEAR(found.at, 0.1 * limit, 0.01 * limit);
}

TEST(CostForecast, LeavesARunInTime) {
  for (const double whole : {0.01, 0.9, 0.99}) {
    const Ending found = ending([whole](double) { return whole; });
    EXPECT_EQ(found.foreseen, -1) << whole;
    EXPECT_NEAR(found.at, whole, 1e-6);
  }
}

TEST(CostForecast, EndsARunOnceItsRestWouldTakeTwiceWhatIsLeft) {
  for (const double whole : {1.1, 1.25, 1.5, 1.75}) {
    const Ending found = ending([whole](double) { return whole; });
    EXPECT_NEAR(found.foreseen, whole, 1e-6);
    EXPECT_NEAR(found.at, 2 * limit - whole, 0.03 * limit) << whole;
  }
}

TEST(CostForecast, LeavesARunInTimeWhoseFirstStepsAreDear) {
  // Three times as dear at first as on average, and falling.
  const Ending falling = ending([](double done) { return 0.95 * 3 * std::pow(1 - done, 2); });
  EXPECT_EQ(falling.foreseen, -1) << falling.at;
  EXPECT_LT(falling.at, limit);
  // Ten times as dear for the first hundredth.
  const Ending start = ending([](double done) { return done < 0.01 ? 9.0 : 0.9; });
  EXPECT_EQ(start.foreseen, -1) << start.at;
}

TEST(CostForecast, CountsTheRestAtNoLessThanHalfTheMeanPace) {
  // Hardly anything for the first twentieth, and then four times the limit.
  const Ending found = ending([](double done) { return done < 0.05 ? 0.1 : 4.0; });
  EXPECT_GT(found.foreseen, 1.5 * limit);
  EXPECT_LT(found.at, 0.5 * limit);
}

TEST(CostForecast, CountsTheRestAtTheCheapestPaceThatWasSeen) {
  // Disturbed now and then, and otherwise in time.
  const Ending disturbed = ending([](double done) { return std::fmod(done, 0.05) < 0.02 ? 1.6 : 0.6; });
  EXPECT_EQ(disturbed.foreseen, -1) << disturbed.at;
  // Dearer and dearer, 35 s in the end.
  const Ending dear = ending([](double done) { return 2.1 + 100 * done * done; });
  EXPECT_GT(dear.foreseen, 1.5 * limit);
  EXPECT_LT(dear.foreseen, 2.5 * limit) << "no dearer than it was so far";
}

TEST(CostForecast, ARunPredictedTooLongEndsEarlyAndSaysSo) {
  constexpr double allowed = 0.1;
  Case spec = pendulum(5, 4);
  spec.method = method("rk4", 1e-7);
  spec.time = {2, 0.02};
  const Trajectory ended = integrate(spec, {}, {allowed, {spec.time.end}});
  EXPECT_EQ(ended.outcome, Outcome::out_of_time);
  EXPECT_GT(ended.foreseen_seconds, 1.5 * allowed);
  EXPECT_NE(ended.message.find("the time allowed, 0.1 s, would not do: it took "), std::string::npos)
      << ended.message;
  EXPECT_NE(ended.message.find("were predicted up to 2 s"), std::string::npos) << ended.message;

  const Trajectory not_asked = integrate(spec, {}, 0.3 * allowed);
  EXPECT_NE(not_asked.message.find("the time allowed, 0.03 s, is over"), std::string::npos)
      << not_asked.message;
  EXPECT_EQ(not_asked.foreseen_seconds, -1);
}

TEST(CostForecast, ForeseesWhatARunThatControlsItsErrorWillTake) {
  constexpr double allowed = 0.1;
  Case spec = pendulum(1, 32);
  spec.method = method("arkode-erk", {});
  spec.method.rtol = spec.method.atol = 1e-13;
  spec.time = {2, 0.02};
  const Trajectory ended = integrate(spec, {}, {allowed, {spec.time.end}});
  EXPECT_EQ(ended.outcome, Outcome::out_of_time);
  EXPECT_GT(ended.foreseen_seconds, 1.5 * allowed) << ended.message;
}

TEST(CostForecast, LetsARunComeToEachTimeAtWhichItIsLookedAt) {
  // A thousandth of the run, which takes some milliseconds, matters by itself.
  constexpr double allowed = 0.05, early = 0.002;
  Case spec = pendulum(5, 4);
  spec.method = method("rk4", 2e-6);
  spec.time = {2, early};
  const Trajectory ended = integrate(spec, {}, {allowed, {early, spec.time.end}});
  EXPECT_EQ(ended.outcome, Outcome::out_of_time);
  EXPECT_GE(ended.end_time, early) << ended.message;
  EXPECT_LT(ended.end_time, 0.5 * spec.time.end) << ended.message;
  EXPECT_GT(ended.foreseen_seconds, 1.5 * allowed) << ended.message;
}

TEST(CostForecast, ARunInTimeIsTheSameAsOneWithoutALimit) {
  Case spec = pendulum(5, 4);
  spec.method = method("rk4", 5e-4);
  spec.time = {2, 0.02};
  const Trajectory free = integrate(spec);
  const Trajectory limited = integrate(spec, {}, {10, {spec.time.end}});
  ASSERT_EQ(limited.outcome, Outcome::completed) << limited.message;
  EXPECT_EQ(limited.q.back(), free.q.back());
  EXPECT_EQ(limited.counters.steps, free.counters.steps);
  EXPECT_EQ(limited.foreseen_seconds, -1);
}

}  // namespace cost_forecast_test
}  // namespace plumb
