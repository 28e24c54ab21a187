#include "render/plot/plot_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/errors.h"
#include "render/gl/dash.h"
#include "render/plot/cell_grid.h"
#include "render/plot/color_bar.h"
#include "render/plot/given_ticks.h"
#include "render/plot/heat_map.h"
#include "render/plot/key_layout.h"
#include "render/plot/legend_layout.h"
#include "render/plot/log_axis_ticks.h"
#include "render/plot/rule_layout.h"

namespace plumb {

namespace {

constexpr double x_margin = 0.02;  // of the data's span, free at either end
constexpr double y_margin = 0.06;

struct Span {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();

  void add(double value) {
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  void add(const std::vector<double>& edges) {
    if (edges.empty()) return;
    add(edges.front());
    add(edges.back());
  }
};

struct PanelRanges {
  AxisRange x;
  AxisRange y;
  Scale x_scale = Scale::linear;
  Scale y_scale = Scale::linear;
};

bool has_place(double value, Scale scale) {
  return std::isfinite(value) && (scale == Scale::linear || value > 0);
}

void add(const Extent& extent, std::size_t point, Scale scale, Span& span) {
  if (extent.lower.empty()) return;
  for (const double end : {extent.lower[point], extent.upper[point]})
    if (has_place(end, scale)) span.add(end);
}

AxisRange fitted(const Span& data, double margin, Scale scale) {
  return scale == Scale::linear ? fitted_range(data.lo, data.hi, margin)
                                : fitted_log_range(data.lo, data.hi, margin);
}

AxisRange given_range(const std::array<double, 2>& range, Scale scale) {
  if (scale == Scale::logarithmic && !(range[0] >= least_log_end && range[1] <= greatest_log_end))
    throw OutputError(fmt::format("plot: a logarithmic axis from {} to {}: must be within {} and {}",
                                  range[0], range[1], least_log_end, greatest_log_end));
  // Between closer ends, neighbouring ticks would be the same number.
  const double least = 1e-9 * std::max(std::abs(range[0]), std::abs(range[1]));
  if (!std::isfinite(range[0]) || !std::isfinite(range[1]) || !(range[1] - range[0] > least))
    throw OutputError(
        fmt::format("plot: an axis from {} to {}: must be finite, ascending and further apart than {:.3g}",
                    range[0], range[1], least));
  return {range[0], range[1]};
}

// The data's span of the panels from `first` to `last`, which share one x axis.
Span x_span(const Plot& plot, std::size_t first, std::size_t last) {
  const Scale scale = plot.panels[last].x.scale;
  Span span;
  for (std::size_t p = first; p <= last; ++p) {
    for (const Series& series : plot.panels[p].series)
      for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!has_place(series.x[i], scale) || !has_place(series.y[i], plot.panels[p].y.scale)) continue;
        span.add(series.x[i]);
        add(series.x_error, i, scale, span);
      }
    if (plot.panels[p].heat_map) span.add(plot.panels[p].heat_map->x_edges);
  }
  return span;
}

Span y_span(const Panel& panel, Scale x_scale) {
  Span span;
  for (const Series& series : panel.series)
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      if (!has_place(series.x[i], x_scale)) continue;
      if (has_place(series.y[i], panel.y.scale)) {
        span.add(series.y[i]);
        add(series.y_error, i, panel.y.scale, span);
      }
      add(series.band, i, panel.y.scale, span);
    }
  if (panel.heat_map) span.add(panel.heat_map->y_edges);
  return span;
}

std::vector<PanelRanges> panel_ranges(const Plot& plot) {
  std::vector<PanelRanges> ranges(plot.panels.size());
  std::size_t first = 0;
  for (std::size_t last = 0; last < plot.panels.size(); ++last) {
    if (plot.panels[last].shares_x_below && last + 1 < plot.panels.size()) continue;
    const Span data = x_span(plot, first, last);
    const Axis& axis = plot.panels[last].x;
    const bool filled = std::any_of(plot.panels.begin() + static_cast<std::ptrdiff_t>(first),
                                    plot.panels.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                                    [](const Panel& panel) { return panel.heat_map.has_value(); });
    const AxisRange shared =
        axis.range ? given_range(*axis.range, axis.scale) : fitted(data, filled ? 0 : x_margin, axis.scale);
    for (; first <= last; ++first) {
      ranges[first].x = shared;
      ranges[first].x_scale = axis.scale;
    }
  }
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const Axis& axis = plot.panels[p].y;
    const Span data = y_span(plot.panels[p], ranges[p].x_scale);
    const double margin = plot.panels[p].heat_map ? 0 : y_margin;
    ranges[p].y = axis.range ? given_range(*axis.range, axis.scale) : fitted(data, margin, axis.scale);
    ranges[p].y_scale = axis.scale;
  }
  return ranges;
}

void widen(AxisRange& range, double span) {
  const double middle = range.lo / 2 + range.hi / 2;
  range = {middle - span / 2, middle + span / 2};
}

void shift(ColorBarLayout& bar, double right) {
  bar.area.left += right;
  bar.area.right += right;
  bar.tick_left += right;
  bar.label_base += right;
}

void equalise(PanelRanges& ranges, const Rect& frame) {
  const double per_pixel =
      std::max((ranges.x.hi - ranges.x.lo) / frame.width(), (ranges.y.hi - ranges.y.lo) / frame.height());
  widen(ranges.x, per_pixel * frame.width());
  widen(ranges.y, per_pixel * frame.height());
}

void check(const Plot& plot) {
  for (const Panel& panel : plot.panels) {
    for (const Series& series : panel.series) {
      if (series.x.size() != series.y.size())
        throw OutputError(fmt::format("plot: series '{}' has {} x and {} y", series.label, series.x.size(),
                                      series.y.size()));
      for (const Extent* extent : {&series.band, &series.x_error, &series.y_error})
        if (extent->lower.size() != extent->upper.size() ||
            (!extent->lower.empty() && extent->lower.size() != series.x.size()))
          throw OutputError(fmt::format("plot: series '{}' has {} points and from {} to {} ends of an extent",
                                        series.label, series.x.size(), extent->lower.size(),
                                        extent->upper.size()));
    }
    for (const Rule& rule : panel.rules)
      if (std::isnan(rule.from) || std::isnan(rule.to))
        throw OutputError(
            fmt::format("plot: rule '{}' from {} to {}: must be numbers", rule.label, rule.from, rule.to));
    for (const Bar& bar : panel.bars)
      for (const double end : {bar.x[0], bar.x[1], bar.y[0], bar.y[1]})
        if (!std::isfinite(end))
          throw OutputError(fmt::format("plot: a bar that ends at {}: must be a finite number", end));
    for (const Axis* axis : {&panel.x, &panel.y})
      if (!axis->tick_labels.empty() && axis->tick_labels.size() != axis->ticks.size())
        throw OutputError(fmt::format("plot: {} labels for {} ticks: must be one each",
                                      axis->tick_labels.size(), axis->ticks.size()));
    if (panel.equal_axes && (panel.x.scale != Scale::linear || panel.y.scale != Scale::linear))
      throw OutputError("plot: equal axes must both be linear");
    if (panel.cells) check_cells(*panel.cells, plot.key.categories.size());
    if (panel.heat_map) check_heat_map(*panel.heat_map);
    if (!(panel.height_share > 0))
      throw OutputError(
          fmt::format("plot: a panel's height share of {}: must be greater than 0", panel.height_share));
  }
  if (!(plot.font_size > 0))
    throw OutputError(fmt::format("plot: a font size of {}: must be greater than 0", plot.font_size));
  if (plot.columns < 1) throw OutputError(fmt::format("plot: {} columns: must be at least 1", plot.columns));
}

bool has_legend(const Panel& panel) {
  return panel.legend && std::any_of(panel.series.begin(), panel.series.end(),
                                     [](const Series& series) { return !series.label.empty(); });
}

double below_title(const Plot& plot, const PlotSizes& sizes) {
  return plot.title.empty() ? 0.6 * sizes.gap : sizes.gap + 1.35 * sizes.title.size;
}

// Lays out the panels below each other, given the heights that legends outside need.
class Stack {
 public:
  /// `key_height` is free between the title and the first panel, pixels.
  Stack(const Plot& plot, const Font& font, double key_height)
      : plot_(plot), font_(font), sizes_(plot.font_size), key_height_(key_height) {}

  PlotLayout lay_out(const std::vector<double>& legend_heights) const {
    PlotLayout layout;
    layout.title_base = sizes_.gap + font_.measure("X", sizes_.title).ascent;
    layout.panels.resize(plot_.panels.size());
    place_vertically(layout, legend_heights);

    const std::vector<PanelRanges> ranges = panel_ranges(plot_);
    double right = right_margin();
    for (std::size_t p = 0; p < layout.panels.size(); ++p) {
      PanelLayout& panel = layout.panels[p];
      panel.y.range = ranges[p].y;
      panel.x.range = ranges[p].x;
      if (!plot_.panels[p].heat_map) continue;
      const HeatMap& map = *plot_.panels[p].heat_map;
      panel.color_bar = color_bar_layout(map, panel.frame.top, panel.frame.bottom, sizes_, font_);
      right = std::max(right, color_bar_width(map, *panel.color_bar, sizes_, font_));
    }
    // The widest y labels set the left end of all frames. With equal axes the labels depend on the frame in
    // turn: the second pass has the frame of the first, which is close enough for the labels to be the same.
    double left = sizes_.gap;
    for (int pass = 0; pass < 2; ++pass) {
      double room = 0;
      for (std::size_t p = 0; p < layout.panels.size(); ++p) {
        PanelLayout& panel = layout.panels[p];
        panel.frame.left = std::round(std::max(left, sizes_.gap));
        panel.frame.right = std::round(plot_.width - right);
        if (panel.frame.width() < 4 * sizes_.tick.size)
          throw OutputError(fmt::format("plot: {} x {} pixels are too few for a font of {}", plot_.width,
                                        plot_.height, plot_.font_size));
        PanelRanges fitted = ranges[p];
        if (plot_.panels[p].equal_axes) equalise(fitted, panel.frame);
        mark(panel, fitted, plot_.panels[x_axis_of(p)].x, plot_.panels[p].y);
        room = std::max(room, left_margin(plot_.panels[p], panel));
      }
      left = room;
    }
    for (std::size_t p = 0; p < layout.panels.size(); ++p) {
      PanelLayout& panel = layout.panels[p];
      panel.y_label_base = sizes_.gap + font_.measure("X", sizes_.label).ascent;
      panel.y_exponent_base = panel.frame.top - 0.45 * sizes_.gap - sizes_.frame;
      panel.rules = rule_layouts(plot_.panels[p], panel, sizes_, font_);
      if (!panel.color_bar) continue;
      shift(*panel.color_bar, panel.frame.right);
      panel.color_bar->exponent_base = panel.y_exponent_base;
    }
    return layout;
  }

  const PlotSizes& sizes() const { return sizes_; }

  // Height of what stands between a frame's top and what is above it.
  double head(std::size_t p, double legend_height) const {
    const Panel& panel = plot_.panels[p];
    double height = 1.2 * sizes_.tick.size;  // a power of ten
    if (!panel.title.empty()) height = std::max(height, 1.45 * sizes_.panel_title.size);
    return height + legend_height;
  }

 private:
  // The panel whose x axis panel p has.
  std::size_t x_axis_of(std::size_t p) const {
    while (!shows_x(p)) ++p;
    return p;
  }

  bool shows_x(std::size_t p) const {
    return !plot_.panels[p].shares_x_below || p + 1 == plot_.panels.size();
  }

  double right_margin() const { return sizes_.gap + sizes_.tick.size; }  // half a tick label

  double left_margin(const Panel& panel, const PanelLayout& layout) const {
    double width = 0;
    for (const std::string& label : layout.y_ticks.labels)
      width = std::max(width, font_.measure(label, sizes_.tick).width);
    width += sizes_.gap + sizes_.tick_length + 0.5 * sizes_.gap;
    if (!panel.y.label.empty()) width += 1.5 * sizes_.label.size;
    return width;
  }

  double foot(std::size_t p) const {
    if (!shows_x(p)) return sizes_.tick_length + 0.2 * sizes_.gap;
    return sizes_.tick_length + 1.35 * sizes_.tick.size + 1.4 * sizes_.label.size + 0.3 * sizes_.gap;
  }

  void place_vertically(PlotLayout& layout, const std::vector<double>& legend_heights) const {
    double top = below_title(plot_, sizes_) + key_height_;
    double free = plot_.height - top - 0.5 * sizes_.gap;
    double shares = 0;
    for (std::size_t p = 0; p < plot_.panels.size(); ++p) {
      free -= head(p, legend_heights[p]) + foot(p);
      shares += plot_.panels[p].height_share;
    }
    for (std::size_t p = 0; p < plot_.panels.size(); ++p) {
      PanelLayout& panel = layout.panels[p];
      const double height = free * plot_.panels[p].height_share / shares;
      if (height < 2 * sizes_.tick.size)
        throw OutputError(fmt::format("plot: {} x {} pixels are too few for {} panels with a font of {}",
                                      plot_.width, plot_.height, plot_.panels.size(), plot_.font_size));
      panel.title_base = top + legend_heights[p] + 1.05 * sizes_.panel_title.size;
      top += head(p, legend_heights[p]);
      panel.frame.top = std::round(top);
      panel.frame.bottom = std::round(top + height);
      panel.x_labels = shows_x(p);
      panel.x_tick_base = panel.frame.bottom + sizes_.tick_length + 1.1 * sizes_.tick.size;
      panel.x_label_base = panel.x_tick_base + 1.35 * sizes_.label.size;
      top += height + foot(p);
    }
  }

  static AxisTicks ticks(const AxisMap& axis, const Axis& given, const TickRoom& room) {
    if (!given.ticks.empty()) return given_ticks(axis, given.ticks, given.tick_labels, room);
    return axis.scale == Scale::linear ? axis_ticks(axis.range.lo, axis.range.hi, room)
                                       : log_axis_ticks(axis.range.lo, axis.range.hi, room);
  }

  void mark(PanelLayout& panel, const PanelRanges& ranges, const Axis& x_axis, const Axis& y_axis) const {
    panel.x = {ranges.x, panel.frame.left, panel.frame.right, ranges.x_scale};
    panel.y = {ranges.y, panel.frame.bottom, panel.frame.top, ranges.y_scale};
    const auto wide = [&](std::string_view label) { return font_.measure(label, sizes_.tick).width; };
    const auto high = [&](std::string_view) { return sizes_.tick.size; };
    panel.x_ticks =
        ticks(panel.x, x_axis, {panel.frame.width(), 5.5 * sizes_.tick.size, 0.6 * sizes_.tick.size, wide});
    panel.y_ticks =
        ticks(panel.y, y_axis, {panel.frame.height(), 2.6 * sizes_.tick.size, 0.2 * sizes_.tick.size, high});
  }

  const Plot& plot_;
  const Font& font_;
  PlotSizes sizes_;
  double key_height_;
};

// One column of panels.
PlotLayout stacked_layout(const Plot& plot, const Font& font, double key_height) {
  const Stack stack(plot, font, key_height);
  std::vector<double> legend_heights(plot.panels.size(), 0);
  PlotLayout layout = stack.lay_out(legend_heights);
  // A legend that goes outside takes height from every panel, after which another may find no place inside.
  for (std::size_t p = 0; p < plot.panels.size();) {
    const Panel& panel = plot.panels[p];
    PanelLayout& placed = layout.panels[p];
    if (!has_legend(panel)) {
      ++p;
    } else if (legend_heights[p] > 0) {
      placed.legend =
          legend_rows(panel, placed.frame.left, placed.frame.top - stack.head(p, legend_heights[p]),
                      placed.frame.width(), stack.sizes(), font);
      ++p;
    } else if ((placed.legend = legend_inside(panel, placed, stack.sizes(), font))) {
      ++p;
    } else {
      legend_heights[p] = legend_rows(panel, 0, 0, placed.frame.width(), stack.sizes(), font).box.height();
      layout = stack.lay_out(legend_heights);
      p = 0;
    }
  }
  return layout;
}

// The panels of one column as a plot of their own. A column that is short of one has an empty one with a
// title, so that rows are level.
Plot column_of(const Plot& plot, int column) {
  Plot part = plot;
  part.panels.clear();
  part.width = plot.width / plot.columns;
  const auto columns = static_cast<std::size_t>(plot.columns);
  Panel filler;
  if (!plot.panels.empty()) filler.title = plot.panels.back().title;
  for (std::size_t p = static_cast<std::size_t>(column);
       p < (plot.panels.size() + columns - 1) / columns * columns; p += columns)
    part.panels.push_back(p < plot.panels.size() ? plot.panels[p] : filler);
  return part;
}

void shift(PanelLayout& panel, double right) {
  if (panel.color_bar) shift(*panel.color_bar, right);
  panel.frame.left += right;
  panel.frame.right += right;
  panel.x.start += right;
  panel.x.end += right;
  panel.y_label_base += right;
  for (RuleLayout& rule : panel.rules) {
    for (Rect* rect : {&rule.area, &rule.label}) {
      rect->left += right;
      rect->right += right;
    }
    rule.at.x() += right;
  }
  if (!panel.legend) return;
  panel.legend->box.left += right;
  panel.legend->box.right += right;
  for (Point& at : panel.legend->at) at.x() += right;
}

}  // namespace

PlotSizes::PlotSizes(double font_size)
    : title{1.1 * font_size, Weight::bold},
      panel_title{font_size, Weight::bold},
      label{font_size, Weight::regular},
      tick{0.92 * font_size, Weight::regular},
      legend{0.92 * font_size, Weight::regular},
      line(0.13 * font_size),
      marker(0.5 * font_size),
      marker_line(0.075 * font_size),
      frame(std::max(1, static_cast<int>(std::lround(0.055 * font_size)))),
      grid(std::max(1, static_cast<int>(std::lround(0.04 * font_size)))),
      tick_length(0.28 * font_size),
      gap(0.6 * font_size) {}

double AxisMap::operator()(double value) const {
  if (scale == Scale::linear) return start + (value - range.lo) / (range.hi - range.lo) * (end - start);
  if (!(value > 0)) return std::numeric_limits<double>::quiet_NaN();
  const double lo = std::log10(range.lo);
  return start + (std::log10(value) - lo) / (std::log10(range.hi) - lo) * (end - start);
}

PlotLayout plot_layout(const Plot& plot, const Font& font) {
  check(plot);
  const PlotSizes sizes(plot.font_size);
  const KeyLayout key = key_layout(plot.key, below_title(plot, sizes), plot.width, sizes, font);
  PlotLayout layout;
  layout.panels.resize(plot.panels.size());
  for (int c = 0; c < plot.columns; ++c) {
    const Plot part = column_of(plot, c);
    PlotLayout column = stacked_layout(part, font, key.height);
    layout.title_base = column.title_base;
    for (std::size_t row = 0; row < column.panels.size(); ++row) {
      const std::size_t p = row * static_cast<std::size_t>(plot.columns) + static_cast<std::size_t>(c);
      if (p >= layout.panels.size()) break;
      shift(column.panels[row], c * part.width);
      layout.panels[p] = std::move(column.panels[row]);
    }
  }
  layout.key = key.entries;
  return layout;
}

std::vector<Point> pixels(const Series& series, const PanelLayout& panel) {
  std::vector<Point> points(series.x.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Far outside, the rasteriser's numbers would not hold the place; nothing there is seen.
    constexpr double far = 1e5;
    const Point p(panel.x(series.x[i]), panel.y(series.y[i]));
    points[i] = p.allFinite() ? Point(p.cwiseMax(-far).cwiseMin(far)) : p;
  }
  return points;
}

Rect bar_area(const Bar& bar, const PanelLayout& panel) {
  const auto [left, right] = std::minmax({panel.x(bar.x[0]), panel.x(bar.x[1])});
  const auto [top, bottom] = std::minmax({panel.y(bar.y[0]), panel.y(bar.y[1])});
  const Rect area{std::max(left, panel.frame.left), std::max(top, panel.frame.top),
                  std::min(right, panel.frame.right), std::min(bottom, panel.frame.bottom)};
  return area.left < area.right && area.top < area.bottom ? area : Rect{};
}

std::string exponent_label(int exponent) {
  if (exponent == 0) return "";
  return fmt::format("\u00d710^{{{}{}}}", exponent < 0 ? "\u2212" : "", std::abs(exponent));
}

double line_sample(const Series& line, double least, const PlotSizes& sizes) {
  if (!(line.line_width > 0) || line.dash == Dash::solid) return least;
  const double width = line.line_width * sizes.line;
  const auto [on, off] = dash_pattern(line.dash, width);
  // Two dashes with their round ends and what is off between them, or four dots.
  const double ends = line.dash == Dash::dashed ? 2 * on + off + width : 4 * on + 3 * off + width;
  return std::max(least, ends);
}

double legend_sample(const Panel& panel, const PlotSizes& sizes) {
  double length = 0;
  for (const Series& series : panel.series) {
    if (series.label.empty()) continue;
    const bool hides_its_dashes =
        series.line_width > 0 && series.dash != Dash::solid && series.marker != Marker::none;
    length = std::max(length, line_sample(series, (hides_its_dashes ? 2.6 : 1.6) * sizes.legend.size, sizes));
  }
  return length;
}

}  // namespace plumb
