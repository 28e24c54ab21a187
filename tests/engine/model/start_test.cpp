#include <gtest/gtest.h>

#include <numbers>

#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace start_test {

TEST(Start, AxialSpeedFollowsTheFirstVibrationOfACableHeldAtItsFirstEnd) {
  Case spec = pendulum(5, 8);
  spec.start.angular_velocity.setZero();
  spec.start.direction = Vec3(2, -1, 2) / 3;
  spec.start.axial_speed = 0.3;
  const Cable cable(spec);
  const Eigen::VectorXd v = cable.start_v(spec.start);
  // Cubic interpolation of a sine over eight elements is off by its fourth derivative times l⁴/384.
  for (const double s : {0.0, 0.1, 0.45, 0.5, 0.9, 1.0}) {
    const Vec3 expected = 0.3 * std::sin(0.5 * std::numbers::pi * s) * spec.start.direction;
    EXPECT_LE((cable.interpolate(v, s) - expected).norm(), 2e-6) << "at " << s;
  }
  for (int node = 0; node <= 8; ++node) {
    const double rate = 0.3 * 0.5 * std::numbers::pi * std::cos(0.5 * std::numbers::pi * node / 8);
    EXPECT_LE((v.segment<3>(6 * node + 3) - rate * spec.start.direction).norm(), 1e-15) << "node " << node;
  }
  // ¼ ρA L v²
  EXPECT_NEAR(cable.energies(cable.start_q(spec.start), v).kinetic, 0.25 * 8e-3 * 0.09, 1e-9);
}

TEST(Start, AxialSpeedIsAddedToTheRotation) {
  Case spec = pendulum(5, 4);
  const Cable cable(spec);
  const Eigen::VectorXd turning = cable.start_v(spec.start);
  StartSpec both = spec.start;
  both.axial_speed = -2;
  StartSpec along = both;
  along.angular_velocity.setZero();
  EXPECT_LE((cable.start_v(both) - turning - cable.start_v(along)).norm(), 1e-15);
  EXPECT_NEAR(cable.start_v(along).tail<6>()[0], -2, 1e-15);
}

TEST(Start, AxialSpeedIsZeroWhereASupportHolds) {
  Case spec = pendulum(5, 4);
  spec.start.axial_speed = 1;
  spec.supports = {Support::clamped, Support::pinned};
  const Cable cable(spec);
  const Eigen::VectorXd v = cable.start_v(spec.start);
  EXPECT_EQ(v.head<3>(), Vec3(0, 0, 0));
  EXPECT_EQ(Vec3(v.tail<6>().head<3>()), Vec3(0, 0, 0));
  EXPECT_GT(v[3], 1) << "a clamped end can stretch";
}

TEST(Start, AxialSpeedSetsOffTheFirstAxialVibration) {
  // Fixed-free at f = 5: 111.072 rad/s; the amplitude of the tip is the speed over that.
  Case spec = pendulum(5, 8);
  spec.cable.strain = StrainModel::engineering_material;
  spec.start.angular_velocity.setZero();
  spec.loads.gravity.setZero();
  spec.start.axial_speed = 1e-2;
  const double period = 2 * std::numbers::pi / 111.072;
  const Trajectory trajectory = run(spec, method("gauss", period / 80), {period, period / 4});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  const double amplitude = 1e-2 / 111.072, off = 1e-4 * amplitude;
  EXPECT_NEAR(tip(trajectory, 1).x() - 1, amplitude, off);
  EXPECT_NEAR(tip(trajectory, 2).x() - 1, 0, off);
  EXPECT_NEAR(tip(trajectory, 3).x() - 1, -amplitude, off);
  EXPECT_NEAR(tip(trajectory, 4).x() - 1, 0, off);
}

}  // namespace start_test
}  // namespace plumb
