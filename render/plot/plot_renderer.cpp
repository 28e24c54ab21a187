#include "render/plot/plot_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/plot/axis_labels.h"
#include "render/plot/band.h"
#include "render/plot/cell_grid.h"
#include "render/plot/color_bar.h"
#include "render/plot/heat_map.h"
#include "render/plot/key_layout.h"
#include "render/plot/plot_layout.h"
#include "render/plot/plot_theme.h"

namespace plumb {

namespace {

constexpr float band_opacity = 0.22F;

class PanelDrawing {
 public:
  PanelDrawing(Painter& painter, const Plot& plot, const Panel& panel, const PanelLayout& layout,
               const PlotSizes& sizes)
      : painter_(painter),
        categories_(plot.key.categories),
        panel_(panel),
        layout_(layout),
        sizes_(sizes),
        dark_(plot.theme == SceneTheme::dark),
        theme_(plot_theme(plot.theme)) {}

  void draw() const {
    if (panel_.heat_map) draw_heat_map(painter_, *panel_.heat_map, layout_);
    if (panel_.cells) draw_cells(painter_, *panel_.cells, categories_, layout_, sizes_);
    for (const RuleLayout& rule : layout_.rules) band(rule);
    if (!panel_.cells && !panel_.heat_map) grid();
    painter_.clip(layout_.frame);
    for (const Bar& bar : panel_.bars)
      if (const Rect area = bar_area(bar, layout_); area.width() > 0) painter_.fill(area, bar.color);
    for (const RuleLayout& rule : layout_.rules) line(rule);
    for (std::size_t i = 0; i < panel_.series.size(); ++i) shade(panel_.series[i], color_of(i));
    for (std::size_t i = 0; i < panel_.series.size(); ++i) {
      const std::vector<Point> points = pixels(panel_.series[i], layout_);
      errors(panel_.series[i], points, color_of(i));
      series(panel_.series[i], points, color_of(i));
    }
    painter_.clip_nothing();
    for (const RuleLayout& rule : layout_.rules) label(rule);
    painter_.frame(layout_.frame, sizes_.frame, theme_.ink);
    labels();
    if (layout_.legend) legend(*layout_.legend);
    if (layout_.color_bar) draw_color_bar(painter_, *panel_.heat_map, *layout_.color_bar, sizes_, theme_);
  }

 private:
  // A given colour, which is chosen for white paper.
  Color shown(const std::optional<Color>& given, Color otherwise) const {
    if (!given) return otherwise;
    return dark_ ? seen_on(theme_, *given) : *given;
  }
  Color color_of(std::size_t series) const {
    return shown(panel_.series[series].color, theme_.series[series % theme_.series.size()]);
  }
  Color color_of(const Rule& rule) const { return shown(rule.color, theme_.rule); }

  void upright(double x, double width, Color color) const {
    const double left = std::round(x - width / 2);
    painter_.fill({left, layout_.frame.top, left + width, layout_.frame.bottom}, color);
  }
  void level(double y, double width, Color color) const {
    const double top = std::round(y - width / 2);
    painter_.fill({layout_.frame.left, top, layout_.frame.right, top + width}, color);
  }

  static bool is_band(const Rule& rule) { return rule.from != rule.to; }

  void band(const RuleLayout& placed) const {
    const Rule& rule = panel_.rules[placed.rule];
    if (!is_band(rule)) return;
    const Color color = color_of(rule);
    painter_.fill(placed.area, {color.r, color.g, color.b, band_opacity});
  }

  // A rule of no width, or the edges of a band that are inside.
  void line(const RuleLayout& placed) const {
    const Rule& rule = panel_.rules[placed.rule];
    const Color color = color_of(rule);
    const double width = is_band(rule) ? sizes_.frame : 0.6 * sizes_.line;
    const Rect& area = placed.area;
    const Rect& frame = layout_.frame;
    const auto draw = [&](const Point& a, const Point& b) {
      painter_.line(std::vector<Point>{a, b}, width, color, rule.dash);
    };
    if (rule.upright) {
      if (area.left > frame.left) draw({area.left, frame.bottom}, {area.left, frame.top});
      if (is_band(rule) && area.right < frame.right)
        draw({area.right, frame.bottom}, {area.right, frame.top});
    } else {
      if (area.top > frame.top) draw({frame.left, area.top}, {frame.right, area.top});
      if (is_band(rule) && area.bottom < frame.bottom)
        draw({frame.left, area.bottom}, {frame.right, area.bottom});
    }
  }

  void label(const RuleLayout& placed) const {
    if (!(placed.label.width() > 0)) return;
    const Rule& rule = panel_.rules[placed.rule];
    const Point middle(placed.label.left / 2 + placed.label.right / 2,
                       placed.label.top / 2 + placed.label.bottom / 2);
    if (!placed.area.contains(middle))
      painter_.fill(placed.label, Color{theme_.paper.r, theme_.paper.g, theme_.paper.b, 0.7F});
    if (rule.upright)
      painter_.turned_text(rule.label, sizes_.legend, placed.at.x(), placed.at.y(), Align::left,
                           theme_.rule_ink);
    else
      painter_.text(rule.label, sizes_.legend, placed.at.x(), placed.at.y(), Align::left, theme_.rule_ink);
  }

  void grid() const {
    for (const double x : layout_.x_ticks.minor) upright(layout_.x(x), sizes_.grid, theme_.minor_grid);
    for (const double y : layout_.y_ticks.minor) level(layout_.y(y), sizes_.grid, theme_.minor_grid);
    for (const double x : layout_.x_ticks.major) upright(layout_.x(x), sizes_.grid, theme_.major_grid);
    for (const double y : layout_.y_ticks.major) level(layout_.y(y), sizes_.grid, theme_.major_grid);
    const auto inside = [](const AxisRange& range) { return range.lo <= 0 && range.hi >= 0; };
    if (panel_.x.zero_line && inside(layout_.x.range)) upright(layout_.x(0), sizes_.frame, theme_.zero);
    if (panel_.y.zero_line && inside(layout_.y.range)) level(layout_.y(0), sizes_.frame, theme_.zero);
  }

  void shade(const Series& s, Color color) const {
    if (s.band.lower.empty()) return;
    std::vector<double> x(s.x.size());
    std::transform(s.x.begin(), s.x.end(), x.begin(), layout_.x);
    painter_.stamp(band_coverage(x, pixels(s.band, layout_.y), layout_.frame), layout_.frame.left,
                   layout_.frame.top, {color.r, color.g, color.b, color.a * band_opacity});
  }

  void errors(const Series& s, const std::vector<Point>& points, Color color) const {
    const double marker = s.marker == Marker::none ? 0 : s.marker_size * sizes_.marker;
    const double cap = std::max(0.8 * marker, 0.6 * sizes_.marker);
    for (const bool along_x : {true, false}) {
      const Extent& extent = along_x ? s.x_error : s.y_error;
      if (extent.lower.empty()) continue;
      const ExtentPixels ends = pixels(extent, along_x ? layout_.x : layout_.y);
      painter_.line(error_bars(points, ends, along_x, cap, marker / 2), sizes_.marker_line, color);
    }
  }

  void series(const Series& s, const std::vector<Point>& points, Color color) const {
    if (s.line_width > 0) painter_.line(points, s.line_width * sizes_.line, color, s.dash);
    if (s.marker != Marker::none) {
      const bool stroked =
          s.marker == Marker::cross || s.marker == Marker::plus || s.marker == Marker::circled_cross;
      const double stroke = s.open_marker || stroked ? sizes_.marker_line : 0;
      painter_.markers(points, s.marker, s.marker_size * sizes_.marker, stroke, color);
    }
  }

  void labels() const {
    const Rect& frame = layout_.frame;
    for (const double value : layout_.x_ticks.major) {
      const double left = std::round(layout_.x(value) - sizes_.frame / 2.0);
      painter_.fill({left, frame.bottom, left + sizes_.frame, frame.bottom + sizes_.tick_length}, theme_.ink);
    }
    for (const double value : layout_.y_ticks.major) {
      const double top = std::round(layout_.y(value) - sizes_.frame / 2.0);
      painter_.fill({frame.left - sizes_.tick_length, top, frame.left, top + sizes_.frame}, theme_.ink);
    }
    minor_marks();
    for (const PlacedText& text : axis_labels(panel_, layout_, sizes_, painter_.font())) {
      const auto draw = text.turned ? &Painter::turned_text : &Painter::text;
      (painter_.*draw)(text.text, text.style, text.at.x(), text.at.y(), text.align, theme_.ink);
    }
  }

  void minor_marks() const {
    const Rect& frame = layout_.frame;
    const double length = 0.5 * sizes_.tick_length;
    for (const double value : layout_.x_ticks.minor) {
      const double left = std::round(layout_.x(value) - sizes_.grid / 2.0);
      painter_.fill({left, frame.bottom, left + sizes_.grid, frame.bottom + length}, theme_.ink);
    }
    for (const double value : layout_.y_ticks.minor) {
      const double top = std::round(layout_.y(value) - sizes_.grid / 2.0);
      painter_.fill({frame.left - length, top, frame.left, top + sizes_.grid}, theme_.ink);
    }
  }

  void legend(const LegendLayout& legend) const {
    if (!legend.outside) {
      painter_.fill(legend.box, Color{theme_.paper.r, theme_.paper.g, theme_.paper.b, 0.88F});
      painter_.frame(legend.box, sizes_.grid, theme_.major_grid);
    }
    for (std::size_t i = 0; i < legend.series.size(); ++i) {
      const std::size_t index = legend.series[i];
      const Point& at = legend.at[i];
      const double y = at.y() - 0.33 * sizes_.legend.size;
      const double length = legend_sample(panel_, sizes_);
      const Series& s = panel_.series[index];
      const Color color = color_of(index);
      Series line = s;
      line.marker = Marker::none;
      const double round_end = s.line_width * sizes_.line / 2;
      series(line, {Point(at.x() + round_end, y), Point(at.x() + length - round_end, y)}, color);
      if (!s.band.lower.empty())
        painter_.fill({at.x(), y - 0.3 * sizes_.legend.size, at.x() + length, y + 0.3 * sizes_.legend.size},
                      {color.r, color.g, color.b, color.a * band_opacity});
      Series marker = s;
      marker.line_width = 0;
      series(marker, {Point(at.x() + length / 2, y)}, color);
      painter_.text(s.label, sizes_.legend, at.x() + length + sizes_.gap, at.y(), Align::left, theme_.ink);
    }
  }

  Painter& painter_;
  const std::vector<CellCategory>& categories_;
  const Panel& panel_;
  const PanelLayout& layout_;
  const PlotSizes& sizes_;
  bool dark_;
  const PlotTheme& theme_;
};

}  // namespace

PlotRenderer::PlotRenderer(const GlContext& context) : context_(context), painter_(context) {}

Image PlotRenderer::draw(const Plot& plot) {
  context_.make_current();
  const PlotLayout layout = plot_layout(plot, painter_.font());
  const PlotSizes sizes(plot.font_size);
  const PlotTheme& theme = plot_theme(plot.theme);
  Canvas canvas(context_, plot.width, plot.height);
  canvas.begin_flat(theme.paper);
  painter_.begin(canvas);
  const PlacedText title = plot_title(plot, layout, sizes, painter_.font());
  painter_.text(title.text, title.style, title.at.x(), title.at.y(), title.align, theme.ink);
  draw_key(painter_, plot.key, layout.key, sizes, theme);
  for (std::size_t p = 0; p < plot.panels.size(); ++p)
    PanelDrawing(painter_, plot, plot.panels[p], layout.panels[p], sizes).draw();
  return canvas.read();
}

}  // namespace plumb
