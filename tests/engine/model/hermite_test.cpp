#include "engine/model/hermite.h"

#include <gtest/gtest.h>

namespace plumb {
namespace hermite_test {

TEST(Hermite, TranslatesRigidly) {
  for (double x : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    const auto s = Hermite::values(x, 0.3);
    EXPECT_DOUBLE_EQ(s[0] + s[2], 1) << "at x = " << x;
  }
}

TEST(Hermite, InterpolatesNodalPositionsAndSlopes) {
  const double l = 0.7;
  EXPECT_EQ(Hermite::values(0, l), (std::array<double, 4>{1, 0, 0, 0}));
  EXPECT_EQ(Hermite::values(1, l), (std::array<double, 4>{0, 0, 1, 0}));
  EXPECT_EQ(Hermite::slopes(0, l), (std::array<double, 4>{0, 1, 0, 0}));
  EXPECT_EQ(Hermite::slopes(1, l), (std::array<double, 4>{0, 0, 0, 1}));
}

TEST(Hermite, DerivativesAreThoseOfTheValues) {
  const double l = 0.7, h = 1e-5;
  for (double x : {0.2, 0.5, 0.9}) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto below = Hermite::values(x - h, l), at = Hermite::values(x, l),
                 above = Hermite::values(x + h, l);
      EXPECT_NEAR(Hermite::slopes(x, l)[i], (above[i] - below[i]) / (2 * h * l), 1e-8) << "s" << i + 1;
      EXPECT_NEAR(Hermite::curvatures(x, l)[i], (above[i] - 2 * at[i] + below[i]) / (h * h * l * l), 1e-4)
          << "s" << i + 1;
    }
  }
}

}  // namespace hermite_test
}  // namespace plumb
