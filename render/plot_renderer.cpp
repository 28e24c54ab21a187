#include "render/plot_renderer.h"

#include <array>

#include "render/cell_grid.h"
#include "render/key_layout.h"
#include "render/plot_layout.h"

namespace plumb {

namespace {

constexpr Color paper = Color::hex(0xFFFFFF);
constexpr Color ink = Color::hex(0x222222);
constexpr Color major_grid = Color::hex(0xDDDDDD);
constexpr Color minor_grid = Color::hex(0xF1F1F1);
constexpr Color zero = Color::hex(0x8C8C8C);
constexpr Color rule_grey = Color::hex(0x8C8C8C);
constexpr Color rule_ink = Color::hex(0x555555);
constexpr float band_opacity = 0.22F;

Color color_of(const Panel& panel, std::size_t series) {
  return panel.series[series].color.value_or(palette[series % palette.size()]);
}

// A text's style, smaller where the text would not fit.
TextStyle fitted(const Painter& painter, std::string_view text, TextStyle style, double room) {
  const double width = painter.font().measure(text, style).width;
  if (width > room) style.size *= room / width;
  return style;
}

class PanelDrawing {
 public:
  PanelDrawing(Painter& painter, const Plot& plot, const Panel& panel, const PanelLayout& layout,
               const PlotSizes& sizes)
      : painter_(painter), categories_(plot.key.categories), panel_(panel), layout_(layout), sizes_(sizes) {}

  void draw() const {
    if (panel_.cells) draw_cells(painter_, *panel_.cells, categories_, layout_, sizes_);
    for (const RuleLayout& rule : layout_.rules) band(rule);
    if (!panel_.cells) grid();
    painter_.clip(layout_.frame);
    for (const Bar& bar : panel_.bars)
      if (const Rect area = bar_area(bar, layout_); area.width() > 0) painter_.fill(area, bar.color);
    for (const RuleLayout& rule : layout_.rules) line(rule);
    for (std::size_t i = 0; i < panel_.series.size(); ++i)
      series(panel_.series[i], pixels(panel_.series[i], layout_), color_of(panel_, i));
    painter_.clip_nothing();
    for (const RuleLayout& rule : layout_.rules) label(rule);
    painter_.frame(layout_.frame, sizes_.frame, ink);
    labels();
    if (layout_.legend) legend(*layout_.legend);
  }

 private:
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
    const Color color = rule.color.value_or(rule_grey);
    painter_.fill(placed.area, {color.r, color.g, color.b, band_opacity});
  }

  // A rule of no width, or the edges of a band that are inside.
  void line(const RuleLayout& placed) const {
    const Rule& rule = panel_.rules[placed.rule];
    const Color color = rule.color.value_or(rule_grey);
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
    if (!placed.area.contains(middle)) painter_.fill(placed.label, Color{paper.r, paper.g, paper.b, 0.7F});
    if (rule.upright)
      painter_.turned_text(rule.label, sizes_.legend, placed.at.x(), placed.at.y(), Align::left, rule_ink);
    else
      painter_.text(rule.label, sizes_.legend, placed.at.x(), placed.at.y(), Align::left, rule_ink);
  }

  void grid() const {
    for (const double x : layout_.x_ticks.minor) upright(layout_.x(x), sizes_.grid, minor_grid);
    for (const double y : layout_.y_ticks.minor) level(layout_.y(y), sizes_.grid, minor_grid);
    for (const double x : layout_.x_ticks.major) upright(layout_.x(x), sizes_.grid, major_grid);
    for (const double y : layout_.y_ticks.major) level(layout_.y(y), sizes_.grid, major_grid);
    const auto inside = [](const AxisRange& range) { return range.lo <= 0 && range.hi >= 0; };
    if (panel_.x.zero_line && inside(layout_.x.range)) upright(layout_.x(0), sizes_.frame, zero);
    if (panel_.y.zero_line && inside(layout_.y.range)) level(layout_.y(0), sizes_.frame, zero);
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
    const double middle_of_digits = 0.36 * sizes_.tick.size;
    for (std::size_t i = 0; i < layout_.x_ticks.major.size(); ++i) {
      const double x = layout_.x(layout_.x_ticks.major[i]);
      const double left = std::round(x - sizes_.frame / 2.0);
      painter_.fill({left, frame.bottom, left + sizes_.frame, frame.bottom + sizes_.tick_length}, ink);
      if (layout_.x_labels)
        painter_.text(layout_.x_ticks.labels[i], sizes_.tick, x, layout_.x_tick_base, Align::center, ink);
    }
    for (std::size_t i = 0; i < layout_.y_ticks.major.size(); ++i) {
      const double y = layout_.y(layout_.y_ticks.major[i]);
      const double top = std::round(y - sizes_.frame / 2.0);
      painter_.fill({frame.left - sizes_.tick_length, top, frame.left, top + sizes_.frame}, ink);
      painter_.text(layout_.y_ticks.labels[i], sizes_.tick,
                    frame.left - sizes_.tick_length - 0.5 * sizes_.gap, y + middle_of_digits, Align::right,
                    ink);
    }
    minor_marks();
    painter_.text(exponent_label(layout_.y_ticks.exponent), sizes_.tick, frame.left, layout_.y_exponent_base,
                  Align::left, ink);
    const TextStyle y_style = fitted(painter_, panel_.y.label, sizes_.label, frame.height() + 2 * sizes_.gap);
    painter_.turned_text(panel_.y.label, y_style, layout_.y_label_base, (frame.top + frame.bottom) / 2,
                         Align::center, ink);
    const double middle = (frame.left + frame.right) / 2;
    painter_.text(panel_.title, fitted(painter_, panel_.title, sizes_.panel_title, frame.width()), middle,
                  layout_.title_base, Align::center, ink);
    if (!layout_.x_labels) return;
    painter_.text(panel_.x.label, fitted(painter_, panel_.x.label, sizes_.label, frame.width()), middle,
                  layout_.x_label_base, Align::center, ink);
    painter_.text(exponent_label(layout_.x_ticks.exponent), sizes_.tick, frame.right, layout_.x_label_base,
                  Align::right, ink);
  }

  // Unequal steps are easier to read with marks of their own.
  void minor_marks() const {
    const Rect& frame = layout_.frame;
    const double length = 0.5 * sizes_.tick_length;
    if (layout_.x.scale == Scale::logarithmic)
      for (const double value : layout_.x_ticks.minor) {
        const double left = std::round(layout_.x(value) - sizes_.grid / 2.0);
        painter_.fill({left, frame.bottom, left + sizes_.grid, frame.bottom + length}, ink);
      }
    if (layout_.y.scale == Scale::logarithmic)
      for (const double value : layout_.y_ticks.minor) {
        const double top = std::round(layout_.y(value) - sizes_.grid / 2.0);
        painter_.fill({frame.left - length, top, frame.left, top + sizes_.grid}, ink);
      }
  }

  void legend(const LegendLayout& legend) const {
    if (!legend.outside) {
      painter_.fill(legend.box, Color{paper.r, paper.g, paper.b, 0.88F});
      painter_.frame(legend.box, sizes_.grid, major_grid);
    }
    for (std::size_t i = 0; i < legend.series.size(); ++i) {
      const std::size_t index = legend.series[i];
      const Point& at = legend.at[i];
      const double y = at.y() - 0.33 * sizes_.legend.size;
      const double length = legend_sample(panel_, sizes_);
      const Series& s = panel_.series[index];
      const Color color = color_of(panel_, index);
      Series line = s;
      line.marker = Marker::none;
      const double round_end = s.line_width * sizes_.line / 2;
      series(line, {Point(at.x() + round_end, y), Point(at.x() + length - round_end, y)}, color);
      Series marker = s;
      marker.line_width = 0;
      series(marker, {Point(at.x() + length / 2, y)}, color);
      painter_.text(s.label, sizes_.legend, at.x() + length + sizes_.gap, at.y(), Align::left, ink);
    }
  }

  Painter& painter_;
  const std::vector<CellCategory>& categories_;
  const Panel& panel_;
  const PanelLayout& layout_;
  const PlotSizes& sizes_;
};

}  // namespace

PlotRenderer::PlotRenderer(const GlContext& context) : context_(context), painter_(context) {}

Image PlotRenderer::draw(const Plot& plot) {
  context_.make_current();
  const PlotLayout layout = plot_layout(plot, painter_.font());
  const PlotSizes sizes(plot.font_size);
  Canvas canvas(context_, plot.width, plot.height);
  canvas.begin_flat(paper);
  painter_.begin(canvas);
  painter_.text(plot.title, fitted(painter_, plot.title, sizes.title, plot.width - 2 * sizes.gap),
                plot.width / 2.0, layout.title_base, Align::center, ink);
  draw_key(painter_, plot.key, layout.key, sizes);
  for (std::size_t p = 0; p < plot.panels.size(); ++p)
    PanelDrawing(painter_, plot, plot.panels[p], layout.panels[p], sizes).draw();
  return canvas.read();
}

}  // namespace plumb
