#include <gtest/gtest.h>

#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace converged_test {

/// Converged figures of the pendulum (64 elements, RK4, by an independent program; 32 elements differ by up
/// to 4e-5 m).
struct Row {
  double t, mid_y, tip_x, tip_z;
};
constexpr Row converged[] = {{0.1, -0.0487477, 0.9172829, -0.3877619},
                             {0.5, -0.3722904, -0.6907387, -0.0868166},
                             {1.0, -0.1082103, 0.6533980, 0.6593451},
                             {2.0, -0.1706383, -0.2398131, 0.9032090}};

TEST(Converged, SixtyFourElementsGiveTheConvergedFiguresToTheirDigits) {
  const Case spec = pendulum(5, 64);
  const Cable cable(spec);
  const Trajectory trajectory = run(spec, method("rk4", 5e-5), {2, 0.1});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  for (const Row& row : converged) {
    const auto k = static_cast<std::size_t>(std::lround(row.t / 0.1));
    EXPECT_NEAR(cable.at(trajectory.q[k], 0.5).position.y(), row.mid_y, 2e-7) << "t = " << row.t;
    EXPECT_NEAR(tip(trajectory, k).x(), row.tip_x, 2e-7) << "t = " << row.t;
    EXPECT_NEAR(tip(trajectory, k).z(), row.tip_z, 2e-7) << "t = " << row.t;
  }
}

TEST(Converged, FourElementsAreTwoCentimetresOff) {
  const Trajectory coarse = run(pendulum(5, 4), method("rk4", 1e-4), {2, 0.02});
  const Trajectory fine = run(pendulum(5, 32), method("rk4", 1e-4), {2, 0.02});
  EXPECT_NEAR(tip_distance(coarse, fine), 2.1e-2, 0.15e-2);
}

}  // namespace converged_test
}  // namespace plumb
