#include "engine/integrate/symmetric_motion.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace symmetric_motion_test {

Case upright(Support first) {
  Case spec = pendulum(5, 4);
  spec.start.direction = {0, 1, 0};
  spec.start.angular_velocity.setZero();
  spec.supports.first = first;
  return spec;
}

double distance_from_line(const Trajectory& run) {
  double greatest = 0;
  for (const Eigen::VectorXd& q : run.q)
    for (Eigen::Index at = 0; at < q.size(); at += 6)
      greatest = std::max(greatest, std::hypot(q[at], q[at + 2]));
  return greatest;
}

TEST(SymmetricMotion, OfASoftCableStandingUprightIsCalledAnUnstableStart) {
  for (const Support first : {Support::pinned, Support::clamped})
    for (const char* name : {"rk4", "energy-momentum", "cvode-bdf"}) {
      const MethodInfo& info = *find_method(name);
      const MethodSpec with = info.takes_step ? method(name, 1e-3) : method(name, {}, 1e-6);
      const Trajectory run = plumb::run(upright(first), with, {2, 0.05});
      const std::string where = fmt::format("{}, {}: {}", name, word(first), run.message);
      ASSERT_EQ(run.outcome, Outcome::completed) << where;
      EXPECT_EQ(distance_from_line(run), 0)
          << where << "\nit left the line, so that there is nothing to remark";
      EXPECT_GE(run.unstable_since, 0) << where;
      EXPECT_EQ(run.remark().find("unstable start"), 0u) << run.remark();
    }
}

// What is told of the motion is true: moved by a ten thousandth of a micrometre it goes elsewhere.
TEST(SymmetricMotion, LeavesItsLineAfterTheLeastDisturbance) {
  const Case spec = upright(Support::pinned);
  const Cable cable(spec);
  State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  start.q[6 * 4] += 1e-10;
  const Trajectory run = integrate(cable, start, method("rk4", 1e-3), {2, 0.05});
  EXPECT_GT(distance_from_line(run), 0.01);
}

TEST(SymmetricMotion, ThatNothingWouldDriveApartHasNoRemark) {
  Case hanging = upright(Support::pinned);
  hanging.start.direction = {0, -1, 0};
  Case swinging = pendulum(5, 4);  // in a plane
  swinging.start.angular_velocity.setZero();
  Case turning = pendulum(5, 4);
  for (const Case& spec : {hanging, swinging, turning}) {
    const Trajectory run = plumb::run(spec, method("rk4", 1e-3), {1, 0.02});
    ASSERT_EQ(run.outcome, Outcome::completed) << run.message;
    EXPECT_EQ(run.remark(), "") << spec.start.direction.transpose();
  }
}

}  // namespace symmetric_motion_test
}  // namespace plumb
