#include "render/legend_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumb {

namespace {

// Of all the places that the data reach, an inner legend may cover this much.
constexpr double bearable_cover = 0.004;

std::vector<std::size_t> labelled(const Panel& panel) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < panel.series.size(); ++i)
    if (!panel.series[i].label.empty()) result.push_back(i);
  return result;
}

double entry_width(const Series& series, const PlotSizes& sizes, const Font& font) {
  return legend_sample(sizes) + sizes.gap + font.measure(series.label, sizes.legend).width;
}

double row_height(const PlotSizes& sizes) {
  return 1.3 * sizes.legend.size;
}

// Places of the data a few pixels apart.
std::vector<Point> samples(const Panel& panel, const PanelLayout& layout, double apart) {
  std::vector<Point> result;
  for (const Series& series : panel.series) {
    const std::vector<Point> points = pixels(series, layout);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i].allFinite()) continue;
      result.push_back(points[i]);
      if (series.line_width <= 0 || i + 1 == points.size() || !points[i + 1].allFinite()) continue;
      const Point way = points[i + 1] - points[i];
      const double pieces = std::min(std::floor(way.norm() / apart), 1000.0);
      for (double k = 1; k < pieces; k += 1) result.emplace_back(points[i] + way * (k / pieces));
    }
  }
  return result;
}

}  // namespace

std::optional<LegendLayout> legend_inside(const Panel& panel, const PanelLayout& layout,
                                          const PlotSizes& sizes, const Font& font) {
  LegendLayout legend;
  legend.series = labelled(panel);
  if (legend.series.empty()) return std::nullopt;
  const double pad = 0.5 * sizes.gap + sizes.frame;
  double width = 0;
  for (const std::size_t i : legend.series)
    width = std::max(width, entry_width(panel.series[i], sizes, font));
  width += 2 * pad;
  const double height = row_height(sizes) * static_cast<double>(legend.series.size()) + 2 * pad;
  const Rect& frame = layout.frame;
  const double margin = sizes.gap;
  if (width + 2 * margin > frame.width() || height + 2 * margin > frame.height()) return std::nullopt;

  const std::vector<Point> data = samples(panel, layout, sizes.gap);
  const double clearance = sizes.marker / 2;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  // Corners before edges before the middle; of equally free places, the first.
  constexpr std::array<std::array<double, 2>, 9> places = {
      {{1, 0}, {0, 0}, {1, 1}, {0, 1}, {0.5, 0}, {0.5, 1}, {1, 0.5}, {0, 0.5}, {0.5, 0.5}}};
  for (const auto& [right, down] : places) {
    const double left = std::round(frame.left + margin + right * (frame.width() - 2 * margin - width));
    const double top = std::round(frame.top + margin + down * (frame.height() - 2 * margin - height));
    const Rect reach{left - clearance, top - clearance, left + width + clearance, top + height + clearance};
    const auto covered = static_cast<std::size_t>(
        std::count_if(data.begin(), data.end(), [&](const Point& p) { return reach.contains(p); }));
    if (covered >= least) continue;
    least = covered;
    legend.box = {left, top, left + width, top + height};
  }
  if (static_cast<double>(least) > bearable_cover * static_cast<double>(data.size())) return std::nullopt;
  for (std::size_t i = 0; i < legend.series.size(); ++i)
    legend.at.emplace_back(
        legend.box.left + pad,
        legend.box.top + pad + row_height(sizes) * static_cast<double>(i) + 0.98 * sizes.legend.size);
  return legend;
}

LegendLayout legend_rows(const Panel& panel, double left, double top, double width, const PlotSizes& sizes,
                         const Font& font) {
  LegendLayout legend;
  legend.outside = true;
  legend.series = labelled(panel);
  double x = left;
  double base = top + 0.98 * sizes.legend.size;
  for (const std::size_t i : legend.series) {
    const double wide = entry_width(panel.series[i], sizes, font);
    if (x > left && x + wide > left + width) {
      x = left;
      base += row_height(sizes);
    }
    legend.at.emplace_back(x, base);
    x += wide + 2 * sizes.gap;
  }
  legend.box = {left, top, left + width, base + 0.32 * sizes.legend.size};
  return legend;
}

}  // namespace plumb
