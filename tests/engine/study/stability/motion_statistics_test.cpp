#include "engine/study/stability/motion_statistics.h"

#include <gtest/gtest.h>

#include "engine/integrate/integrate.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace motion_statistics_test {

TEST(MotionStatistics, AreThoseOfKnownHeightsAndSpeeds) {
  Trajectory run;
  run.elements = 1;
  run.outcome = Outcome::completed;
  for (const double height : {1.0, 3.0}) {
    run.times.push_back(height);
    run.q.push_back(Eigen::VectorXd::Zero(12));
    run.v.push_back(Eigen::VectorXd::Zero(12));
    run.q.back()[8] = height;  // gravity is along -Z
    run.v.back()[6] = 5;
    run.energies.push_back({height, 0, 0, 0});
  }
  Case spec = pendulum(5, 1);
  spec.loads.gravity = {0, 0, -9.81};
  MotionStatistics found;
  take_statistics(spec, run, found);
  EXPECT_TRUE(found.taken);
  EXPECT_DOUBLE_EQ(found.mean_height, 2);
  EXPECT_DOUBLE_EQ(found.height_deviation, 1);
  EXPECT_DOUBLE_EQ(found.rms_speed, 5);
  EXPECT_DOUBLE_EQ(found.energy_change, 2);
}

TEST(MotionStatistics, OfNeighboursThatPartedAgreeAndOfRegularMotionsThereAreNone) {
  Case spec = pendulum(1, 2);
  spec.time = {4, 0.02};
  const ReferenceMotion parting = reference_motion(spec, 1, 1e-2, 1);
  ASSERT_FALSE(parting.divergence.beyond_end);
  const auto variants = method_variants({"energy-momentum"});
  const std::vector<MotionStatistics> found = motion_statistics({&parting}, variants, 2e-3, 20);
  ASSERT_EQ(found.size(), 3U);
  for (const MotionStatistics& one : found) {
    ASSERT_TRUE(one.taken) << one.label << ": " << one.message;
    EXPECT_NEAR(one.mean_height, found[0].mean_height, 0.15) << one.label;
    EXPECT_NEAR(one.rms_speed, found[0].rms_speed, 0.3) << one.label;
    EXPECT_NEAR(one.energy_change, 0, 1e-6) << one.label;
  }
  EXPECT_NE(found[1].mean_height, found[0].mean_height) << "the neighbour has parted";

  spec = pendulum(5, 2);
  spec.time = {1, 0.02};
  const ReferenceMotion regular = reference_motion(spec, 5, 1e-2, 1);
  EXPECT_TRUE(motion_statistics({&regular}, variants, 2e-3, 20).empty());
}

}  // namespace motion_statistics_test
}  // namespace plumb
