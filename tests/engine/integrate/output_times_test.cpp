#include <gtest/gtest.h>

#include "engine/integrate/state_at.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace output_times_test {

TEST(OutputTimes, AreMultiplesOfTheIntervalAndTheEnd) {
  EXPECT_EQ(output_times({2, 0.02}).size(), 101u);
  EXPECT_EQ(output_times({2, 0.02}).back(), 2);
  EXPECT_EQ(output_times({1, 0.4}), (std::vector<double>{0, 0.4, 0.8, 1}));
  EXPECT_EQ(output_times({1, 1}), (std::vector<double>{0, 1}));
}

TEST(OutputTimes, StepsNeedNotFitTheOutputs) {
  const TimeSpec odd{0.35, 0.02};
  const Trajectory exact = run(pendulum(5, 4), method("arkode-erk", {}, 1e-11), odd);
  for (const auto& [name, h] : {std::pair{"rk4", 3e-4}, std::pair{"generalized-alpha", 3e-4}}) {
    const Trajectory seen = run(pendulum(5, 4), method(name, h), odd);
    EXPECT_EQ(seen.times, exact.times);
    EXPECT_GT(seen.interpolated_outputs, 0);
    EXPECT_EQ(seen.end_time, 0.35);
    EXPECT_LE(tip_distance(seen, exact), 1e-4) << name;
  }
}

TEST(OutputTimes, StepLongerThanTheIntervalIsTakenAsItIs) {
  const Trajectory seen = run(pendulum(5, 4), method("linearly-implicit-euler", 0.05), {0.2, 0.02});
  EXPECT_EQ(seen.counters.steps, 4);
  EXPECT_EQ(seen.times.size(), 11u);
}

TEST(StateAt, IsTheOutputAtItsTimeAndCubicBetween) {
  // q = t³ and t² are represented exactly by cubic Hermite polynomials.
  Trajectory trajectory;
  for (const double t : {0.0, 0.5, 1.25}) {
    trajectory.times.push_back(t);
    trajectory.q.push_back(Eigen::Vector2d(t * t * t, t * t));
    trajectory.v.push_back(Eigen::Vector2d(3 * t * t, 2 * t));
  }
  EXPECT_EQ(state_at(trajectory, 0.5).q, trajectory.q[1]);
  EXPECT_EQ(state_at(trajectory, 0).q, trajectory.q[0]);
  EXPECT_EQ(state_at(trajectory, 1.25).q, trajectory.q[2]);
  for (const double t : {0.1, 0.7, 1.2}) {
    EXPECT_NEAR(state_at(trajectory, t).q[0], t * t * t, 1e-14);
    EXPECT_NEAR(state_at(trajectory, t).v[1], 2 * t, 1e-14);
  }
  EXPECT_THROW(state_at(trajectory, 1.3), std::out_of_range);
  EXPECT_THROW(state_at(trajectory, -0.1), std::out_of_range);
  EXPECT_THROW(state_at(Trajectory{}, 0), std::out_of_range);
}

}  // namespace output_times_test
}  // namespace plumb
