#include "render/plot/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/errors.h"
#include "render/image/color_map.h"
#include "render/plot/cell_grid.h"

namespace plumb {
namespace {

constexpr std::size_t outside = std::numeric_limits<std::size_t>::max();

// Which interval between the edges each pixel's middle is in, from pixel `first` on.
std::vector<std::size_t> intervals(const std::vector<double>& edges, const AxisMap& axis, double first,
                                   int pixels) {
  std::vector<double> at(edges.size());
  std::transform(edges.begin(), edges.end(), at.begin(), axis);
  std::vector<std::size_t> result(static_cast<std::size_t>(pixels), outside);
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const auto [from, to] = std::minmax({at[k], at[k + 1]});
    if (!std::isfinite(from) || !std::isfinite(to)) continue;
    const int begin = static_cast<int>(std::clamp<double>(std::ceil(from - first - 0.5), 0, pixels));
    const int end = static_cast<int>(std::clamp<double>(std::ceil(to - first - 0.5), 0, pixels));
    std::fill(result.begin() + begin, result.begin() + std::max(begin, end), k);
  }
  return result;
}

void put(Color color, std::uint8_t* pixel) {
  int k = 0;
  for (const float part : {color.r, color.g, color.b, color.a})
    pixel[k++] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0F, 1.0F)));
}

}  // namespace

void check_heat_map(const HeatMap& map) {
  check_edges(map.x_edges);
  check_edges(map.y_edges);
  const std::size_t columns = std::max<std::size_t>(1, map.x_edges.size()) - 1;
  const std::size_t rows = std::max<std::size_t>(1, map.y_edges.size()) - 1;
  if (map.values.size() != rows * columns || map.values.empty())
    throw OutputError(
        fmt::format("plot: {} values of a heat map for {} rows of {}", map.values.size(), rows, columns));
  if (!map.range) return;
  const auto [lo, hi] = *map.range;
  if (!std::isfinite(lo) || !std::isfinite(hi) || !(lo < hi))
    throw OutputError(fmt::format("plot: colours from {} to {}: must be finite and ascending", lo, hi));
}

AxisRange color_range(const HeatMap& map) {
  if (map.range) return {(*map.range)[0], (*map.range)[1]};
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  for (const double value : map.values)
    if (std::isfinite(value)) {
      lo = std::min(lo, value);
      hi = std::max(hi, value);
    }
  if (map.diverging && lo <= hi) {
    hi = std::max(std::abs(lo), std::abs(hi));
    lo = -hi;
  }
  return fitted_range(lo, hi, 0);
}

Color color_of(const HeatMap& map, const AxisRange& range, double value) {
  const double share = (value - range.lo) / (range.hi - range.lo);
  return map.diverging ? diverging_map_color(share) : map_color(share);
}

void draw_heat_map(Painter& painter, const HeatMap& map, const PanelLayout& panel) {
  const Rect& frame = panel.frame;
  ColorBitmap picture;
  picture.width = static_cast<int>(frame.width());
  picture.height = static_cast<int>(frame.height());
  const auto width = static_cast<std::size_t>(picture.width);
  picture.rgba.assign(4 * width * static_cast<std::size_t>(picture.height), 0);
  const std::vector<std::size_t> column_at = intervals(map.x_edges, panel.x, frame.left, picture.width);
  const std::vector<std::size_t> row_at = intervals(map.y_edges, panel.y, frame.top, picture.height);
  const std::size_t columns = map.x_edges.size() - 1;
  const AxisRange range = color_range(map);

  std::vector<std::uint8_t> colors(4 * map.values.size(), 0);
  for (std::size_t k = 0; k < map.values.size(); ++k)
    if (std::isfinite(map.values[k])) put(color_of(map, range, map.values[k]), &colors[4 * k]);
  for (std::size_t y = 0; y < row_at.size(); ++y)
    for (std::size_t x = 0; x < column_at.size(); ++x)
      if (row_at[y] != outside && column_at[x] != outside)
        std::copy_n(&colors[4 * (row_at[y] * columns + column_at[x])], 4, &picture.rgba[4 * (y * width + x)]);
  painter.picture(picture, frame.left, frame.top);
}

}  // namespace plumb
