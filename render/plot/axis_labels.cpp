#include "render/plot/axis_labels.h"

namespace plumb {
namespace {

constexpr double cap_height = 0.73, descent = 0.24;  // of DejaVu Sans, of its size

// A text's style, smaller where the text would not fit.
TextStyle fitted(const Font& font, const std::string& text, TextStyle style, double room) {
  const double width = font.measure(text, style).width;
  if (width > room) style.size *= room / width;
  return style;
}

}  // namespace

Rect PlacedText::box(const Font& font) const {
  const double width = font.measure(text, style).width, up = cap_height * style.size,
               down = descent * style.size;
  const double before = align == Align::left ? 0 : align == Align::center ? width / 2 : width;
  if (turned) return {at.x() - up, at.y() - width + before, at.x() + down, at.y() + before};
  return {at.x() - before, at.y() - up, at.x() - before + width, at.y() + down};
}

std::vector<PlacedText> axis_labels(const Panel& panel, const PanelLayout& layout, const PlotSizes& sizes,
                                    const Font& font) {
  std::vector<PlacedText> texts;
  const auto add = [&](const std::string& text, TextStyle style, const Point& at, Align align,
                       bool turned = false) {
    if (!text.empty()) texts.push_back({text, style, at, align, turned});
  };
  const Rect& frame = layout.frame;
  const double middle_of_digits = cap_height / 2 * sizes.tick.size, middle = (frame.left + frame.right) / 2;
  for (std::size_t i = 0; i < layout.x_ticks.major.size() && layout.x_labels; ++i)
    add(layout.x_ticks.labels[i], sizes.tick, {layout.x(layout.x_ticks.major[i]), layout.x_tick_base},
        Align::center);
  for (std::size_t i = 0; i < layout.y_ticks.major.size(); ++i)
    add(layout.y_ticks.labels[i], sizes.tick,
        {frame.left - sizes.tick_length - 0.5 * sizes.gap,
         layout.y(layout.y_ticks.major[i]) + middle_of_digits},
        Align::right);
  add(exponent_label(layout.y_ticks.exponent), sizes.tick, {frame.left, layout.y_exponent_base}, Align::left);
  add(panel.y.label, fitted(font, panel.y.label, sizes.label, frame.height() + 2 * sizes.gap),
      {layout.y_label_base, (frame.top + frame.bottom) / 2}, Align::center, true);
  add(panel.title, fitted(font, panel.title, sizes.panel_title, frame.width()), {middle, layout.title_base},
      Align::center);
  if (!layout.x_labels) return texts;
  const std::string power = exponent_label(layout.x_ticks.exponent);
  const double beside = power.empty() ? 0 : font.measure(power, sizes.tick).width + sizes.gap;
  add(panel.x.label, fitted(font, panel.x.label, sizes.label, frame.width() - 2 * beside),
      {middle, layout.x_label_base}, Align::center);
  add(power, sizes.tick, {frame.right, layout.x_label_base}, Align::right);
  return texts;
}

PlacedText plot_title(const Plot& plot, const PlotLayout& layout, const PlotSizes& sizes, const Font& font) {
  return {plot.title,
          fitted(font, plot.title, sizes.title, plot.width - 2 * sizes.gap),
          {plot.width / 2.0, layout.title_base},
          Align::center};
}

}  // namespace plumb
