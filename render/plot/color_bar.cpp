#include "render/plot/color_bar.h"

#include <algorithm>
#include <cmath>

#include "render/plot/heat_map.h"

namespace plumb {
namespace {

double widest_tick(const ColorBarLayout& bar, const PlotSizes& sizes, const Font& font) {
  double width = 0;
  for (const std::string& label : bar.ticks.labels)
    width = std::max(width, font.measure(label, sizes.tick).width);
  return width;
}

}  // namespace

ColorBarLayout color_bar_layout(const HeatMap& map, double top, double bottom, const PlotSizes& sizes,
                                const Font& font) {
  ColorBarLayout bar;
  bar.area = {std::round(sizes.gap), top, std::round(sizes.gap + 0.9 * sizes.tick.size), bottom};
  bar.values = {color_range(map), bottom, top, Scale::linear};
  const auto high = [&](std::string_view) { return sizes.tick.size; };
  bar.ticks = axis_ticks(bar.values.range.lo, bar.values.range.hi,
                         {bottom - top, 2.6 * sizes.tick.size, 0.2 * sizes.tick.size, high});
  bar.tick_left = bar.area.right + sizes.tick_length + 0.4 * sizes.gap;
  bar.label_base = bar.tick_left + widest_tick(bar, sizes, font) + 1.35 * sizes.label.size;
  return bar;
}

double color_bar_width(const HeatMap& map, const ColorBarLayout& bar, const PlotSizes& sizes,
                       const Font& font) {
  const double exponent = font.measure(exponent_label(bar.ticks.exponent), sizes.tick).width;
  const double labels = map.label.empty() ? bar.tick_left + widest_tick(bar, sizes, font)
                                          : bar.label_base + 0.3 * sizes.label.size;
  return std::max(labels, bar.area.left + exponent) + 0.5 * sizes.gap;
}

void draw_color_bar(Painter& painter, const HeatMap& map, const ColorBarLayout& bar, const PlotSizes& sizes,
                    const PlotTheme& theme) {
  const int rows = static_cast<int>(bar.area.height());
  ColorBitmap colors;
  colors.width = static_cast<int>(bar.area.width());
  colors.height = rows;
  const AxisRange& range = bar.values.range;
  for (int y = 0; y < rows; ++y) {
    const double value = range.hi - (range.hi - range.lo) * (y + 0.5) / rows;
    const Color color = color_of(map, range, value);
    for (int x = 0; x < colors.width; ++x)
      for (const float part : {color.r, color.g, color.b, 1.0F})
        colors.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * part)));
  }
  painter.picture(colors, bar.area.left, bar.area.top);
  painter.frame(bar.area, sizes.frame, theme.ink);
  const double middle_of_digits = 0.36 * sizes.tick.size;
  for (std::size_t k = 0; k < bar.ticks.major.size(); ++k) {
    const double y = bar.values(bar.ticks.major[k]);
    const double top = std::round(y - sizes.frame / 2.0);
    painter.fill({bar.area.right, top, bar.area.right + sizes.tick_length, top + sizes.frame}, theme.ink);
    painter.text(bar.ticks.labels[k], sizes.tick, bar.tick_left, y + middle_of_digits, Align::left,
                 theme.ink);
  }
  painter.text(exponent_label(bar.ticks.exponent), sizes.tick, bar.area.left, bar.exponent_base, Align::left,
               theme.ink);
  TextStyle style = sizes.label;
  const double length = painter.font().measure(map.label, style).width;
  const double room = bar.area.height() + 2 * sizes.gap;
  if (length > room) style.size *= room / length;
  painter.turned_text(map.label, style, bar.label_base, (bar.area.top + bar.area.bottom) / 2, Align::center,
                      theme.ink);
}

}  // namespace plumb
