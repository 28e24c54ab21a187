#include "engine/study/reference/trajectory_divergence.h"

#include <gtest/gtest.h>

#include "engine/study/reference/node_distance.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace separation_test {

constexpr double tolerance = 1e-3;

double distance_at(const TrajectoryDivergence& divergence, double t) {
  for (std::size_t k = 0; k < divergence.times.size(); ++k)
    if (std::abs(divergence.times[k] - t) < 1e-9) return divergence.distances[k];
  ADD_FAILURE() << "no output at " << t << " s";
  return -1;
}

// Independent programs: two runs of the stiff pendulum by rk4 agree to 8e-11 m at 1 s and are 1.4e-2 m apart
// within 2 s.
TEST(TrajectoryDivergence, OfTheStiffPendulumIsFast) {
  const TrajectoryDivergence divergence = plumb::divergence(pendulum(1, 4), 1, tolerance);
  EXPECT_EQ(divergence.parameter, 1);
  EXPECT_EQ(divergence.elements, 4);
  EXPECT_NEAR(divergence.distances.front(), start_distance, 1e-3 * start_distance);
  EXPECT_LT(distance_at(divergence, 1), 1e-5);
  EXPECT_GT(divergence.distances.back(), tolerance);
  EXPECT_FALSE(divergence.beyond_end);
  EXPECT_GT(divergence.horizon, 1);
  EXPECT_LT(divergence.horizon, 2);
  EXPECT_GT(divergence.exponent, 5);
  EXPECT_NE(divergence.in_words.find("only energies"), std::string::npos) << divergence.in_words;
}

TEST(TrajectoryDivergence, DoesNotDependOnTheSizeOfThePendulum) {
  Case metres = pendulum(1, 4), nanometres = metres;
  metres.time.end = nanometres.time.end = 1.5;
  const double L = std::exp2(-27);
  nanometres.cable.length *= L;
  nanometres.cable.area *= L * L;
  nanometres.cable.second_moment *= L * L * L * L;
  nanometres.cable.density /= L * L * L;
  nanometres.cable.youngs_modulus /= L;
  nanometres.loads.gravity *= L;
  const TrajectoryDivergence large = plumb::divergence(metres, 1, tolerance);
  const TrajectoryDivergence small = plumb::divergence(nanometres, 1, tolerance * L);
  EXPECT_GT(large.horizon, 1);
  EXPECT_NEAR(small.horizon, large.horizon, 1e-9);
  EXPECT_NEAR(small.exponent, large.exponent, 0.01 * large.exponent) << small.in_words;
}

TEST(TrajectoryDivergence, OfTheSoftPendulumIsSlow) {
  const TrajectoryDivergence divergence = plumb::divergence(pendulum(5, 4), 5, tolerance);
  EXPECT_TRUE(divergence.beyond_end);
  EXPECT_EQ(divergence.horizon, 2);
  EXPECT_LT(divergence.distances.back(), 100 * start_distance);
  EXPECT_LT(divergence.exponent, 3);
  EXPECT_NE(divergence.in_words.find("to the end"), std::string::npos) << divergence.in_words;
}

TEST(TrajectoryDivergence, OfARigidTurnWithoutLoadIsNoneButTheDriftOfItsSpeed) {
  Case spec = pendulum(20, 2);
  spec.loads.gravity.setZero();
  spec.start.angular_velocity.setZero();
  spec.time = {20, 0.1};
  const TrajectoryDivergence divergence = plumb::divergence(spec, 20, tolerance);
  EXPECT_TRUE(divergence.beyond_end);
  EXPECT_LT(std::abs(divergence.exponent), 0.2) << divergence.in_words;
}

TEST(TrajectoryDivergence, HasAShorterHorizonForATighterToleranceAndAWiderStart) {
  const Case spec = pendulum(1, 4);
  const double horizon = divergence(spec, 1, 1e-3).horizon;
  EXPECT_LT(divergence(spec, 1, 1e-6).horizon, horizon);
  EXPECT_LT(divergence(spec, 1, 1e-3, 1e-6).horizon, horizon);
}

// What the horizon claims, by another method than the one that found it: the same equations with two steps.
TEST(TrajectoryDivergence, IsThatOfTwoRunsByAnotherMethod) {
  const TimeSpec time{2, 0.02};
  const Trajectory one = run(pendulum(1, 4), method("rk4", 5e-5), time);
  const Trajectory other = run(pendulum(1, 4), method("rk4", 4e-5), time);
  EXPECT_LT(node_distance(one, other, 1), 1e-3);
  EXPECT_GT(node_distance(one, other, 2), 1e-3);
  EXPECT_LT(node_distance(run(pendulum(5, 4), method("rk4", 2e-5), time),
                          run(pendulum(5, 4), method("rk4", 1.6e-5), time), 2),
            1e-6);
}

TEST(TrajectoryDivergence, ThatCannotBeFollowedSaysSo) {
  Case spec = pendulum(5, 4);
  // The slopes of a cable that turns so fast that it is torn.
  spec.start.angular_velocity = {0, 1e6, 0};
  const TrajectoryDivergence divergence = plumb::divergence(spec, 5, tolerance);
  EXPECT_FALSE(divergence.beyond_end) << divergence.in_words;
}

}  // namespace separation_test
}  // namespace plumb
