#include "engine/study/reference/node_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/study/reference/classify_outcome.h"

namespace plumb {
namespace node_distance_test {

/// Three nodes that rest, over five outputs.
Trajectory at_rest() {
  Trajectory run;
  run.outcome = Outcome::completed;
  run.elements = 2;
  run.element_length = 0.5;
  run.end_time = 0.4;
  for (int k = 0; k < 5; ++k) {
    Eigen::VectorXd q(18);
    q << 0, 0, 0, 1, 0, 0, 0.5, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0;
    run.times.push_back(0.1 * k);
    run.q.push_back(q);
    run.v.push_back(Eigen::VectorXd::Zero(18));
    run.energies.push_back({1, 0, 0, 0});
  }
  return run;
}

Trajectory displaced(std::size_t output, Eigen::Index coordinate, double by) {
  Trajectory run = at_rest();
  run.q[output][coordinate] += by;
  return run;
}

TEST(NodeDistance, IsThatOfAnyNodeAndOfNoSlope) {
  EXPECT_EQ(node_distance(at_rest(), at_rest(), 1), 0);
  for (const Eigen::Index coordinate : {0, 1, 2, 6, 7, 8, 12, 13, 14})
    EXPECT_NEAR(node_distance(displaced(2, coordinate, -0.25), at_rest(), 1), 0.25, 1e-15) << coordinate;
  for (const Eigen::Index coordinate : {3, 4, 5, 9, 15, 17})
    EXPECT_EQ(node_distance(displaced(2, coordinate, -0.25), at_rest(), 1), 0) << coordinate;
}

TEST(NodeDistance, CountsUpToItsTimeOnly) {
  const Trajectory run = displaced(3, 7, 0.25);
  EXPECT_EQ(node_distance(run, at_rest(), run.times[2]), 0);
  EXPECT_EQ(node_distance(run, at_rest(), run.times[3]), 0.25);
  EXPECT_EQ(together_until(run, at_rest(), 0.2), run.times[2]);
  EXPECT_EQ(together_until(run, at_rest(), 0.25), run.times[4]);
  EXPECT_EQ(together_until(displaced(0, 7, 0.25), at_rest(), 0.2), -1);
}

TEST(NodeDistance, OfWhatIsNotANumberIsBeyondAll) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Trajectory run = displaced(1, 7, bad);
    EXPECT_TRUE(std::isinf(node_distance(run, at_rest(), 1)));
    EXPECT_EQ(together_until(run, at_rest(), 1e300), 0);
    EXPECT_EQ(classify_outcome(run, at_rest(), 1e300, 1).outcome, Outcome::inaccurate);
  }
}

TEST(NodeDistance, OfOtherTimesOrMeshesIsNone) {
  Trajectory other = at_rest();
  other.times[1] = 0.15;
  EXPECT_EQ(node_distance(other, at_rest(), 1), -1);
  other = at_rest();
  for (Eigen::VectorXd& q : other.q) q.conservativeResize(12);
  EXPECT_EQ(node_distance(other, at_rest(), 1), -1);
  EXPECT_EQ(node_distance(at_rest(), Trajectory{}, 1), -1);
  EXPECT_EQ(classify_outcome(at_rest(), Trajectory{}, 1, 1).outcome, Outcome::completed)
      << "without a reference nothing is known of a run";
}

TEST(ClassifyOutcome, ARunDisplacedBeyondToleranceIsNotAccurate) {
  constexpr double tolerance = 1e-3;
  EXPECT_EQ(classify_outcome(at_rest(), at_rest(), tolerance, 1).outcome, Outcome::accurate);
  for (const std::size_t output : {0U, 2U, 4U})
    for (const Eigen::Index coordinate : {1, 7, 13}) {
      EXPECT_EQ(classify_outcome(displaced(output, coordinate, 0.999e-3), at_rest(), tolerance, 1).outcome,
                Outcome::accurate);
      const Judgement judged =
          classify_outcome(displaced(output, coordinate, 1.001e-3), at_rest(), tolerance, 1);
      EXPECT_EQ(judged.outcome, Outcome::inaccurate) << "output " << output << ", coordinate " << coordinate;
      EXPECT_NEAR(judged.error, 1.001e-3, 1e-12);
    }
}

}  // namespace node_distance_test
}  // namespace plumb
