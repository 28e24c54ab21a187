#include "render/scene/frame_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/image/color_map.h"
#include "render/plot/axis_ticks.h"
#include "render/plot/plot_layout.h"

namespace plumb {

namespace {

/// The measures that everything in a frame goes by, pixels.
struct Sheet {
  Sheet(int wide, int high)
      : size(frame_text_size(wide, high)), margin(1.1 * size), width(wide), base(high - margin) {}

  double size;
  double margin;
  double width;
  double base;  // line of the lowest texts
};

double draw_time(Painter& painter, const FrameTexts& texts, const Sheet& sheet) {
  painter.text(texts.time, {sheet.size}, sheet.margin, sheet.base, Align::left, texts.ink);
  return sheet.margin + painter.font().measure(texts.time, {sheet.size}).width;
}

// Base line of the title.
double draw_title(Painter& painter, const FrameTexts& texts, const Sheet& sheet) {
  TextStyle title{1.05 * sheet.size, Weight::bold};
  const double wide = painter.font().measure(texts.title, title).width;
  title.size *= std::min(1.0, (sheet.width - 2 * sheet.margin) / std::max(wide, 1.0));
  const double base = sheet.margin + 0.75 * title.size;
  painter.text(texts.title, title, sheet.margin, base, Align::left, texts.ink);
  return base;
}

// Its left end.
double draw_scale_bar(Painter& painter, const FrameTexts& texts, const Sheet& sheet) {
  const double size = sheet.size;
  const double metres = round_step(0.08 * sheet.width / texts.pixels_per_metre);
  const double length = std::round(metres * texts.pixels_per_metre);
  const double right = std::round(sheet.width - sheet.margin);
  const double thick = std::max(2.0, std::round(size / 10));
  const double tick = std::round(size / 3);
  const double bar = std::round(sheet.base - 0.3 * size);
  painter.fill({right - length, bar, right, bar + thick}, texts.quiet_ink);
  painter.fill({right - length, bar - tick, right - length + thick, bar}, texts.quiet_ink);
  painter.fill({right - thick, bar - tick, right, bar}, texts.quiet_ink);
  const std::string label = fmt::format("{:g} m", metres);
  const double wide = painter.font().measure(label, {0.85 * size}).width;
  const double middle = right - std::max(length, wide) / 2;
  painter.text(label, {0.85 * size}, middle, bar - tick - 0.2 * size, Align::center, texts.quiet_ink);
  return right - std::max(length, wide);
}

void draw_labels(Painter& painter, const FrameTexts& texts, const Sheet& sheet, double title_base) {
  const double size = 0.85 * sheet.size;
  const double sample = 1.6 * size;
  double base = texts.title.empty() ? sheet.margin + 0.75 * size : title_base + 1.5 * size;
  for (const FrameLabel& label : texts.labels) {
    const double middle = base - 0.36 * size;
    const std::array<Point, 2> ends = {Point(sheet.margin + 0.1 * size, middle),
                                       Point(sheet.margin + sample, middle)};
    if (label.marker == Marker::none)
      painter.line(ends, std::max(2.0, size / 5), label.color);
    else
      painter.markers(std::array{Point((ends[0] + ends[1]) / 2)}, label.marker, 0.6 * size, 0, label.color);
    painter.text(label.text, {size}, sheet.margin + sample + 0.5 * size, base, Align::left, texts.ink);
    base += 1.35 * size;
  }
}

// How far above the lowest base line the bar's title reaches.
constexpr double bar_rise = 2.9;    // text sizes
constexpr double row_height = 2.0;  // of the lowest texts, where the bar has no room between them
constexpr double bar_width = 15;
constexpr double least_bar = 9;

bool is_bar_raised(double room, double size) {
  return room < (least_bar + 3) * size;
}

void draw_color_bar(Painter& painter, const FrameTexts& texts, const Sheet& sheet, double left,
                    double right) {
  const ColorBar& bar = *texts.bar;
  const double size = sheet.size;
  double base = sheet.base;
  if (is_bar_raised(right - left, size)) {
    base -= row_height * size;
    left = sheet.margin - size;
    right = sheet.width - sheet.margin + size;
  }
  const double wide = std::round(std::min(bar_width * size, right - left - 3 * size));
  const double start = std::round((left + right - wide) / 2);
  const TextStyle style{0.75 * size};
  const double bottom = std::round(base - 1.0 * size), top = std::round(bottom - 0.5 * size);
  constexpr int steps = 128;
  for (int k = 0; k < steps; ++k)
    painter.fill(
        {std::round(start + wide * k / steps), top, std::round(start + wide * (k + 1) / steps), bottom},
        map_color((k + 0.5) / steps));

  const AxisTicks ticks =
      axis_ticks(bar.lo, bar.hi, {wide, 4 * size, 0.6 * size, [&](std::string_view label) {
                                    return painter.font().measure(label, style).width;
                                  }});
  const double thick = std::max(1.0, std::round(size / 16));
  for (std::size_t i = 0; i < ticks.major.size(); ++i) {
    const double x = start + wide * (ticks.major[i] - bar.lo) / (bar.hi - bar.lo);
    painter.fill({x - thick / 2, bottom, x + thick / 2, bottom + 0.2 * size}, texts.quiet_ink);
    painter.text(ticks.labels[i], style, x, base, Align::center, texts.quiet_ink);
  }
  TextStyle title{0.85 * size};
  const std::string text = fmt::format("{} [{}] {}", bar.title, bar.unit, exponent_label(ticks.exponent));
  title.size *= std::min(1.0, (right - left - 2 * size) / painter.font().measure(text, title).width);
  painter.text(text, title, start + wide / 2, top - 0.4 * size, Align::center, texts.ink);
}

}  // namespace

double frame_text_size(int width, int height) {
  if (width < 200 || height < 120) return 0;  // no room that would be legible
  return std::max(11.0, height / 27.0);
}

ViewMargins margins_beside(const FrameTexts& texts, int width, int height) {
  ViewMargins margins;
  const double size = frame_text_size(width, height);
  if (!(size > 0)) return margins;
  const double high = height;
  const auto share = [&](double pixels) { return 1 - 2 * pixels / high; };
  if (texts.bar) {
    // A raised bar is allowed for where the texts beside it could leave it too little room.
    const double room = 0.74 * width - 9 * size;
    const double rise = bar_rise + (is_bar_raised(room, size) ? row_height : 0);
    margins.bottom = std::min(margins.bottom, share((1.1 + rise + 0.5) * size));
  }
  if (!texts.labels.empty()) {
    const double lines = static_cast<double>(texts.labels.size());
    margins.top = std::min(margins.top, share((2.4 + 1.15 * lines) * size));
  }
  margins.top = std::max(margins.top, 0.2);
  margins.bottom = std::max(margins.bottom, 0.2);
  return margins;
}

void draw_texts(Painter& painter, const FrameTexts& texts, int width, int height) {
  const Sheet sheet(width, height);
  if (!(sheet.size > 0)) return;
  const double left = draw_time(painter, texts, sheet);
  const double title_base = draw_title(painter, texts, sheet);
  const double right = draw_scale_bar(painter, texts, sheet);
  draw_labels(painter, texts, sheet, title_base);
  if (texts.bar) draw_color_bar(painter, texts, sheet, left, right);
}

}  // namespace plumb
