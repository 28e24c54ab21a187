#include "render/gl/dash.h"

#include <algorithm>

namespace plumb {

std::array<double, 2> dash_pattern(Dash dash, double width) {
  if (dash == Dash::dotted) return {0.001 * width, 2.2 * width};
  return {4 * width, dash == Dash::dashed ? 3 * width : 0};
}

std::vector<std::pair<Point, Point>> dash_segments(std::span<const Point> points, Dash dash, double width) {
  const std::array<double, 2> pattern = dash_pattern(dash, width);
  std::vector<std::pair<Point, Point>> pieces;
  std::size_t phase = 0;
  double left = pattern[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    const bool starts = i == 0 || !points[i - 1].allFinite();
    const bool ends = i + 1 == points.size() || !points[i + 1].allFinite();
    if (starts) {
      phase = 0;
      left = pattern[0];
      if (ends) pieces.emplace_back(points[i], points[i]);
    }
    if (ends) continue;
    const Point& a = points[i];
    const Point& b = points[i + 1];
    if (dash == Dash::solid || !(width > 0)) {
      pieces.emplace_back(a, b);
      continue;
    }
    const double length = (b - a).norm();
    for (double at = 0; at < length;) {
      // Decided by what is added rather than by what is left, which rounding may keep above 0 for ever.
      const bool turns = at + left <= length;
      const double next = turns ? at + left : length;
      if (phase == 0) pieces.emplace_back(a + (b - a) * (at / length), a + (b - a) * (next / length));
      left -= next - at;
      at = next;
      if (turns) {
        phase = 1 - phase;
        left = pattern[phase];
      }
    }
  }
  return pieces;
}

}  // namespace plumb
