#include "render/plot/band.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace plumb {
namespace band_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double area(const TextBitmap& bitmap) {
  return std::accumulate(bitmap.coverage.begin(), bitmap.coverage.end(), 0.0) / 255;
}

TEST(Band, CoversTheAreaOfItsTrapezoids) {
  EXPECT_TRUE(rc::check([] {
    const auto any = [] { return *rc::gen::inRange(0, 4000) / 20.0; };  // in a frame of 200 by 200
    std::vector<double> x = {any()};
    ExtentPixels ends;
    double exact = 0;
    for (int k = 0; k < 6; ++k) {
      if (k > 0) x.push_back(std::min(200.0, x.back() + any() / 6));
      const double a = any(), b = any();
      ends.lower.push_back(std::max(a, b));
      ends.upper.push_back(std::min(a, b));
      if (k == 0) continue;
      const auto i = static_cast<std::size_t>(k);
      exact +=
          (x[i] - x[i - 1]) * (ends.lower[i] - ends.upper[i] + ends.lower[i - 1] - ends.upper[i - 1]) / 2;
    }
    // A quarter of a pixel at either end of a segment at most, of a height of 200.
    const double found = area(band_coverage(x, ends, {0, 0, 200, 200}));
    RC_ASSERT(std::abs(found - exact) <= 6 * 0.25 * 200 + 0.01 * exact);
  }));
}

TEST(Band, HasItsWholePixelsFullAndOthersEmpty) {
  const std::vector<double> x = {10, 20};
  const TextBitmap bitmap = band_coverage(x, {{30, 30}, {25.5, 25.5}}, {5, 10, 105, 60});
  const auto at = [&](int column, int row) {
    return static_cast<int>(
        bitmap.coverage[static_cast<std::size_t>((row - 10) * bitmap.width + column - 5)]);
  };
  EXPECT_EQ(at(10, 29), 255);
  EXPECT_EQ(at(19, 26), 255);
  EXPECT_EQ(at(15, 25), 128) << "half";
  EXPECT_EQ(at(15, 24), 0);
  EXPECT_EQ(at(15, 30), 0);
  EXPECT_EQ(at(9, 28), 0);
  EXPECT_EQ(at(20, 28), 0);
}

TEST(Band, IsCutAtTheFrameAndBrokenByWhatIsNotFinite) {
  const std::vector<double> x = {-1e5, 1e5};
  EXPECT_NEAR(area(band_coverage(x, {{1e5, 1e5}, {-1e5, -1e5}}, {0, 0, 40, 30})), 1200, 1e-6);
  const std::vector<double> four = {0, 10, 20, 30};
  EXPECT_NEAR(area(band_coverage(four, {{10, nan, 10, 10}, {0, 0, 0, 0}}, {0, 0, 30, 30})), 100, 1e-6);
}

TEST(Band, OnALogarithmicAxisGoesToItsStartWhereItHasNoPlace) {
  const AxisMap axis{{1e-3, 1}, 300, 0, Scale::logarithmic};
  const ExtentPixels ends = pixels(Extent{{-1, 0, 1e-2}, {1e-1, nan, 1}}, axis);
  EXPECT_EQ(ends.lower[0], 300);
  EXPECT_EQ(ends.lower[1], 300);
  EXPECT_NEAR(ends.lower[2], 200, 1e-9);
  EXPECT_NEAR(ends.upper[0], 100, 1e-9);
  EXPECT_TRUE(std::isnan(ends.upper[1]));
}

TEST(ErrorBars, HaveAStemAndTwoCapsUnlessTheMarkerHidesThem) {
  const std::vector<Point> points = {{100, 100}, {200, 100}, {nan, 100}, {300, 100}};
  const ExtentPixels ends{{140, 103, 150, nan}, {60, 97, 50, 90}};
  const std::vector<Point> strokes = error_bars(points, ends, false, 10, 5);
  ASSERT_EQ(strokes.size(), 9U) << "of the first point alone: the second's are short, others not numbers";
  EXPECT_EQ(strokes[0], Point(100, 140));
  EXPECT_EQ(strokes[1], Point(100, 60));
  EXPECT_FALSE(strokes[2].allFinite());
  EXPECT_EQ(strokes[3], Point(95, 140));
  EXPECT_EQ(strokes[4], Point(105, 140));
  const std::vector<Point> level = error_bars(points, {{80, 0, 0, nan}, {130, 0, 0, nan}}, true, 10, 25);
  ASSERT_GE(level.size(), 2U);
  EXPECT_EQ(level[0], Point(80, 100));
  EXPECT_EQ(level[1], Point(130, 100));
}

}  // namespace band_test
}  // namespace plumb
