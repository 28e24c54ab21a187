#include "engine/study/yardstick.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumb {
namespace yardstick_test {

TEST(Yardstick, IsTheLeastTimeOfWorkThatComesToTheRightEnd) {
  const Yardstick taken = yardstick();
  EXPECT_EQ(taken.steps, 20000);
  EXPECT_GE(taken.repeats.size(), 5U);
  EXPECT_EQ(taken.seconds, *std::min_element(taken.repeats.begin(), taken.repeats.end()));
  EXPECT_GT(taken.seconds, 5e-3) << "too short to be told from noise";
  // Where the tip of the published pendulum is at 2 s, converged (cases/references/pendulum_converged.toml).
  EXPECT_NEAR(taken.tip[0], -0.2398131, 1e-4);
  EXPECT_NEAR(taken.tip[2], 0.9032090, 1e-4);
}

}  // namespace yardstick_test
}  // namespace plumb
