#include "render/gl/dash.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumb {
namespace dash_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double drawn(std::span<const Point> points, Dash dash, double width) {
  double length = 0;
  for (const auto& [a, b] : dash_segments(points, dash, width)) length += (b - a).norm();
  return length;
}

TEST(Dash, SolidLineIsDrawnWhole) {
  const std::vector<Point> points = {{0, 0}, {30, 40}, {30, 100}};
  EXPECT_DOUBLE_EQ(drawn(points, Dash::solid, 2), 110);
}

TEST(Dash, DashedLineIsDrawnAsFarAsItsPatternSays) {
  const std::vector<Point> points = {{0, 0}, {140, 0}};
  EXPECT_NEAR(drawn(points, Dash::dashed, 2), 80, 1e-9) << "ten times 8 on, 6 off";
}

TEST(Dash, PatternRunsOnAroundCorners) {
  std::vector<Point> corners;
  for (int i = 0; i <= 140; ++i) corners.emplace_back(i, i % 2 == 0 ? 0 : 1e-9);
  EXPECT_NEAR(drawn(corners, Dash::dashed, 2), 80, 1e-6);
}

TEST(Dash, LinesOfAnyLengthAndWidthAreDrawnInFinitelyManyPieces) {
  for (const double width : {0.0, 0.1, 1.0 / 3, 4.68})
    for (const auto& [step, steps] : {std::pair{0.1, 49}, {1.0 / 3, 49}, {7 * 4.68, 49}, {1e5, 4}}) {
      std::vector<Point> points;
      for (int i = 0; i <= steps; ++i) points.emplace_back(i * step, 0);
      EXPECT_LE(drawn(points, Dash::dotted, width), steps * step * (1 + 1e-12)) << width << " " << step;
      EXPECT_GT(drawn(points, Dash::dashed, width), 0) << width << " " << step;
    }
}

TEST(Dash, NotANumberBreaksTheLineAndALonePointIsADot) {
  const std::vector<Point> points = {{0, 0}, {10, 0}, {nan, 0}, {50, 0}, {60, nan}, {70, 0}, {75, 0}};
  const auto pieces = dash_segments(points, Dash::solid, 2);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_DOUBLE_EQ(drawn(points, Dash::solid, 2), 15);
  EXPECT_EQ(pieces[1].first, pieces[1].second);
}

}  // namespace dash_test
}  // namespace plumb
