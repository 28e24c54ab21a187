#include "render/plot/legend_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/plot/band.h"

namespace plumb {

namespace {

// Of all the places that the data reach, an inner legend may cover this much.
constexpr double bearable_cover = 0.004;

// Up to so many entries stand below each other.
constexpr std::size_t one_column = 6;

std::vector<std::size_t> labelled(const Panel& panel) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < panel.series.size(); ++i)
    if (!panel.series[i].label.empty()) result.push_back(i);
  return result;
}

double entry_width(const Panel& panel, const Series& series, const PlotSizes& sizes, const Font& font) {
  return legend_sample(panel, sizes) + sizes.gap + font.measure(series.label, sizes.legend).width;
}

bool hides_a_rule(const PanelLayout& layout, const Rect& box) {
  return std::any_of(layout.rules.begin(), layout.rules.end(), [&](const RuleLayout& rule) {
    const Rect& label = rule.label;
    return label.width() > 0 && label.left < box.right && label.right > box.left && label.top < box.bottom &&
           label.bottom > box.top;
  });
}

double row_height(const PlotSizes& sizes) {
  return 1.3 * sizes.legend.size;
}

// From one end to the other, upright or level.
void add_between(const Point& from, const Point& to, double apart, std::vector<Point>& samples) {
  const double pieces = std::max(1.0, std::floor((to - from).lpNorm<1>() / apart));
  for (double k = 0; k <= pieces; k += 1) samples.emplace_back(from + (to - from) * (k / pieces));
}

// What bands and error bars reach, as far as it is in the frame.
void add_extents(const Series& series, const PanelLayout& layout, double apart, std::vector<Point>& samples) {
  const Rect& frame = layout.frame;
  const auto in_x = [&](double x) { return std::clamp(x, frame.left, frame.right); };
  const auto in_y = [&](double y) { return std::clamp(y, frame.top, frame.bottom); };
  double last = -std::numeric_limits<double>::infinity();
  const ExtentPixels band = pixels(series.band, layout.y);
  const ExtentPixels x_error = pixels(series.x_error, layout.x), y_error = pixels(series.y_error, layout.y);
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const Point at(layout.x(series.x[i]), layout.y(series.y[i]));
    const auto upright = [&](const ExtentPixels& ends) {
      if (ends.lower.empty() || std::isnan(ends.lower[i]) || std::isnan(ends.upper[i])) return;
      add_between({at.x(), in_y(ends.lower[i])}, {at.x(), in_y(ends.upper[i])}, apart, samples);
    };
    if (!(at.x() >= frame.left && at.x() <= frame.right)) continue;
    if (std::abs(at.x() - last) >= apart) {
      upright(band);
      last = at.x();
    }
    upright(y_error);
    if (x_error.lower.empty() || std::isnan(x_error.lower[i]) || std::isnan(x_error.upper[i])) continue;
    if (at.y() >= frame.top && at.y() <= frame.bottom)
      add_between({in_x(x_error.lower[i]), at.y()}, {in_x(x_error.upper[i]), at.y()}, apart, samples);
  }
}

}  // namespace

std::vector<Point> data_samples(const Panel& panel, const PanelLayout& layout, double apart) {
  std::vector<Point> result;
  for (const Bar& bar : panel.bars) {
    const Rect area = bar_area(bar, layout);
    for (double y = area.top; y < area.bottom; y += apart)
      for (double x = area.left; x < area.right; x += apart) result.emplace_back(x, y);
  }
  if (panel.heat_map)
    for (double y = layout.frame.top; y < layout.frame.bottom; y += apart)
      for (double x = layout.frame.left; x < layout.frame.right; x += apart) result.emplace_back(x, y);
  for (const Series& series : panel.series) {
    add_extents(series, layout, apart, result);
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

namespace {

// Of equal width and filled one after the other.
struct Columns {
  std::size_t count;
  std::size_t rows;
  double way;  // from one column to the next
};

Columns columns(std::size_t entries, std::size_t wished, double entry, const PlotSizes& sizes) {
  const std::size_t rows = (entries + wished - 1) / wished;
  return {(entries + rows - 1) / rows, rows, entry + 2 * sizes.gap};
}

Point place_in(const Columns& columns, std::size_t entry, double left, double top, const PlotSizes& sizes) {
  return {left + columns.way * static_cast<double>(entry / columns.rows),
          top + row_height(sizes) * static_cast<double>(entry % columns.rows) + 0.98 * sizes.legend.size};
}

double widest_entry(const Panel& panel, const std::vector<std::size_t>& entries, const PlotSizes& sizes,
                    const Font& font) {
  double width = 0;
  for (const std::size_t i : entries)
    width = std::max(width, entry_width(panel, panel.series[i], sizes, font));
  return width;
}

std::optional<LegendLayout> legend_inside(const Panel& panel, const PanelLayout& layout,
                                          const std::vector<Point>& data, std::size_t column_count,
                                          const PlotSizes& sizes, const Font& font) {
  LegendLayout legend;
  legend.series = labelled(panel);
  const double pad = 0.5 * sizes.gap + sizes.frame;
  const double entry = widest_entry(panel, legend.series, sizes, font);
  const Columns shape = columns(legend.series.size(), column_count, entry, sizes);
  const double width = entry + static_cast<double>(shape.count - 1) * shape.way + 2 * pad;
  const double height = row_height(sizes) * static_cast<double>(shape.rows) + 2 * pad;
  const Rect& frame = layout.frame;
  const double margin = sizes.gap;
  if (width + 2 * margin > frame.width() || height + 2 * margin > frame.height()) return std::nullopt;

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
    if (hides_a_rule(layout, reach)) continue;
    if (covered >= least) continue;
    least = covered;
    legend.box = {left, top, left + width, top + height};
  }
  if (least == std::numeric_limits<std::size_t>::max() ||
      static_cast<double>(least) > bearable_cover * static_cast<double>(data.size()))
    return std::nullopt;
  for (std::size_t i = 0; i < legend.series.size(); ++i)
    legend.at.push_back(place_in(shape, i, legend.box.left + pad, legend.box.top + pad, sizes));
  return legend;
}

}  // namespace

std::optional<LegendLayout> legend_inside(const Panel& panel, const PanelLayout& layout,
                                          const PlotSizes& sizes, const Font& font) {
  const std::size_t entries = labelled(panel).size();
  if (entries == 0) return std::nullopt;
  const std::vector<Point> data = data_samples(panel, layout, sizes.gap);
  const std::size_t most_columns = entries > one_column ? 3 : 1;
  for (std::size_t count = 1; count <= most_columns; ++count)
    if (auto legend = legend_inside(panel, layout, data, count, sizes, font)) return legend;
  return std::nullopt;
}

LegendLayout legend_rows(const Panel& panel, double left, double top, double width, const PlotSizes& sizes,
                         const Font& font) {
  LegendLayout legend;
  legend.outside = true;
  legend.series = labelled(panel);
  std::vector<double> widths;
  for (const std::size_t i : legend.series)
    widths.push_back(entry_width(panel, panel.series[i], sizes, font) + 2 * sizes.gap);
  // Filled column by column, each as wide as its widest entry, in as few rows as fit.
  std::size_t rows = 0;
  double room = 0;
  std::vector<double> columns;
  do {
    ++rows;
    columns.clear();
    for (std::size_t i = 0; i < widths.size(); ++i) {
      if (i % rows == 0) columns.push_back(0);
      columns.back() = std::max(columns.back(), widths[i]);
    }
    room = width + 2 * sizes.gap;
    for (const double column : columns) room -= column;
  } while (room < 0 && rows < widths.size());
  const double margin = rows > 1 ? 0.5 * sizes.gap : 0;
  double x = left;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (i > 0 && i % rows == 0) x += columns[i / rows - 1];
    legend.at.emplace_back(
        x, top + margin + row_height(sizes) * static_cast<double>(i % rows) + 0.98 * sizes.legend.size);
  }
  legend.box = {left, top, left + width,
                top + margin + row_height(sizes) * static_cast<double>(rows - 1) + 1.3 * sizes.legend.size};
  return legend;
}

}  // namespace plumb
