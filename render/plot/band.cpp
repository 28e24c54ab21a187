#include "render/plot/band.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

double place(const AxisMap& axis, double value) {
  if (std::isnan(value)) return value;
  constexpr double far = 1e5;  // as of the points of a series
  if (axis.scale == Scale::logarithmic && !(value > 0)) return axis.start;
  return std::clamp(axis(value), -far, far);
}

}  // namespace

ExtentPixels pixels(const Extent& extent, const AxisMap& axis) {
  ExtentPixels result;
  for (const double value : extent.lower) result.lower.push_back(place(axis, value));
  for (const double value : extent.upper) result.upper.push_back(place(axis, value));
  return result;
}

TextBitmap band_coverage(std::span<const double> x, const ExtentPixels& ends, const Rect& frame) {
  constexpr int samples = 4;  // in a pixel's width
  TextBitmap bitmap;
  bitmap.width = static_cast<int>(frame.width());
  bitmap.height = static_cast<int>(frame.height());
  const auto width = static_cast<std::size_t>(bitmap.width);
  std::vector<float> covered(width * static_cast<std::size_t>(bitmap.height), 0);
  const auto add = [&](int column, double a, double b) {
    const auto [low, high] = std::minmax({a, b});
    const double top = std::clamp(low - frame.top, 0.0, frame.height());
    const double bottom = std::clamp(high - frame.top, 0.0, frame.height());
    for (int row = static_cast<int>(top); row < bottom && row < bitmap.height; ++row) {
      const double part = std::min(bottom, row + 1.0) - std::max(top, static_cast<double>(row));
      covered[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] +=
          static_cast<float>(part / samples);
    }
  };
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const std::size_t left = x[k] <= x[k + 1] ? k : k + 1, right = 2 * k + 1 - left;
    bool finite = true;
    for (const double value :
         {x[k], x[k + 1], ends.lower[k], ends.lower[k + 1], ends.upper[k], ends.upper[k + 1]})
      finite = finite && std::isfinite(value);
    if (!finite || !(x[right] > x[left])) continue;
    // Middles of quarters of a pixel, each in one segment only.
    const auto quarter = [&](double at) { return std::ceil((at - frame.left) * samples - 0.5); };
    const int first = static_cast<int>(std::max(quarter(x[left]), 0.0));
    const int end = static_cast<int>(std::min(quarter(x[right]), samples * frame.width()));
    for (int s = first; s < end; ++s) {
      const double share = (frame.left + (s + 0.5) / samples - x[left]) / (x[right] - x[left]);
      add(s / samples, std::lerp(ends.lower[left], ends.lower[right], share),
          std::lerp(ends.upper[left], ends.upper[right], share));
    }
  }
  bitmap.coverage.resize(covered.size());
  std::transform(covered.begin(), covered.end(), bitmap.coverage.begin(), [](float part) {
    return static_cast<std::uint8_t>(std::lround(255 * std::min(part, 1.0F)));
  });
  return bitmap;
}

std::vector<Point> error_bars(std::span<const Point> points, const ExtentPixels& ends, bool along_x,
                              double cap, double hidden) {
  const Point gap = Point::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<Point> strokes;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!points[k].allFinite() || std::isnan(ends.lower[k]) || std::isnan(ends.upper[k])) continue;
    const double at = along_x ? points[k].x() : points[k].y();
    if (std::max(std::abs(ends.lower[k] - at), std::abs(ends.upper[k] - at)) <= hidden) continue;
    Point low = points[k], high = points[k], half(0, 0);
    (along_x ? low.x() : low.y()) = ends.lower[k];
    (along_x ? high.x() : high.y()) = ends.upper[k];
    (along_x ? half.y() : half.x()) = cap / 2;
    for (const Point& p : {low, high, gap, Point(low - half), Point(low + half), gap, Point(high - half),
                           Point(high + half), gap})
      strokes.push_back(p);
  }
  return strokes;
}

}  // namespace plumb
