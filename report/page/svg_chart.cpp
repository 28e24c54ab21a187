#include "report/page/svg_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/plot/log_axis_ticks.h"
#include "report/base/escape.h"
#include "report/figure/number_markup.h"

namespace plumb {
namespace {

constexpr double letter = 6.5;  // width of one in the size of the labels

double width_of(std::string_view text) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return letter * static_cast<double>(letters);
}

struct PlacedAxis {
  const SvgAxis& axis;
  double begin, end;  // in the units of the chart

  bool holds(double value) const { return std::isfinite(value) && (!axis.logarithmic || value > 0); }
  double at(double value) const {
    const auto scale = [&](double v) { return axis.logarithmic ? std::log10(v) : v; };
    return begin + (end - begin) * (scale(value) - scale(axis.from)) / (scale(axis.to) - scale(axis.from));
  }
};

std::vector<std::pair<double, std::string>> ticks_of(const PlacedAxis& placed, double spacing) {
  if (!placed.axis.ticks.empty()) return placed.axis.ticks;
  const bool upright = placed.end < placed.begin;
  const TickRoom room{std::abs(placed.end - placed.begin), spacing, 8,
                      [=](std::string_view text) { return upright ? 14.0 : width_of(text); }};
  const AxisTicks ticks = placed.axis.logarithmic ? log_axis_ticks(placed.axis.from, placed.axis.to, room)
                                                  : axis_ticks(placed.axis.from, placed.axis.to, room);
  std::vector<std::pair<double, std::string>> all;
  for (std::size_t k = 0; k < ticks.major.size(); ++k) {
    std::string label = plain_text(ticks.labels[k]);
    if (ticks.exponent != 0 && !label.empty() && ticks.major[k] != 0)
      label += plain_text(fmt::format("·10^{{{}}}", ticks.exponent));
    all.emplace_back(ticks.major[k], label);
  }
  return all;
}

std::string mark_of(const SvgMark& mark, double x, double y) {
  const std::string circle =
      fmt::format(R"(<circle class="{}{}"{}{} cx="{:.1f}" cy="{:.1f}" r="{}"><title>{}</title></circle>)",
                  mark.css, mark.hollow ? " hollow" : "", mark.data.empty() ? "" : " ", mark.data, x, y,
                  mark.hollow ? 2.6 : 3.6, escape_xml(mark.title));
  return mark.link.empty() ? circle : fmt::format(R"(<a href="{}">{}</a>)", escape_xml(mark.link), circle);
}

}  // namespace

SvgAxis fitted_axis(const std::vector<double>& values, bool logarithmic, const std::string& label) {
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  for (const double value : values) {
    if (!std::isfinite(value) || (logarithmic && !(value > 0))) continue;
    const double kept = logarithmic ? std::clamp(value, least_log_end, greatest_log_end) : value;
    lo = std::min(lo, kept);
    hi = std::max(hi, kept);
  }
  const AxisRange range = logarithmic ? fitted_log_range(lo, hi, 0.06) : fitted_range(lo, hi, 0.06);
  return {range.lo, range.hi, logarithmic, label};
}

std::string to_svg(const SvgChart& chart) {
  constexpr double right = 12, top = 8, bottom = 38;
  const PlacedAxis y{chart.y, chart.height - bottom, top};
  const auto y_ticks = ticks_of(y, 42);
  // Tick labels have the room they need beside the turned label of the axis.
  constexpr double label_room = 20, least_left = 58;
  double left = least_left;
  for (const auto& [value, label] : y_ticks) left = std::max(left, label_room + width_of(label) + 6);
  const PlacedAxis x{chart.x, left, chart.width - right};
  // A picture has no parts; one that leads somewhere is a group of them.
  const bool leads = std::any_of(chart.marks.begin(), chart.marks.end(),
                                 [](const SvgMark& mark) { return !mark.link.empty(); });
  std::string svg = fmt::format(R"(<svg class="chart" viewBox="0 0 {} {}" role="{}" aria-label="{}">)",
                                chart.width, chart.height, leads ? "group" : "img", escape_xml(chart.alt));
  for (const auto& [value, label] : ticks_of(x, 90))
    svg += fmt::format(
        R"(<path class="grid" d="M{0:.1f} {1:.1f}V{2:.1f}"/><text x="{0:.1f}" y="{3:.1f}" text-anchor="middle">{4}</text>)",
        x.at(value), y.begin, y.end, y.begin + 15, escape_xml(label));
  for (const auto& [value, label] : y_ticks)
    svg += fmt::format(
        R"(<path class="grid" d="M{0:.1f} {1:.1f}H{2:.1f}"/><text x="{3:.1f}" y="{4:.1f}" text-anchor="end">{5}</text>)",
        x.begin, y.at(value), x.end, x.begin - 6, y.at(value) + 4, escape_xml(label));
  svg += fmt::format(R"(<path class="frame" d="M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}"/>)", x.begin, y.end, y.begin,
                     x.end);
  svg += fmt::format(R"(<text class="label" x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)",
                     (x.begin + x.end) / 2, chart.height - 6, escape_xml(chart.x.label));
  svg += fmt::format(
      R"svg(<text class="label" transform="translate(12 {:.1f}) rotate(-90)" text-anchor="middle">{}</text>)svg",
      (y.begin + y.end) / 2, escape_xml(chart.y.label));
  for (const SvgLine& line : chart.lines) {
    std::string path;
    for (const auto& [px, py] : line.points)
      if (x.holds(px) && y.holds(py))
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.at(px), y.at(py));
    if (!path.empty()) svg += fmt::format(R"(<path class="{}" d="{}"/>)", line.css, path);
  }
  for (const SvgMark& mark : chart.marks)
    if (x.holds(mark.x) && y.holds(mark.y)) svg += mark_of(mark, x.at(mark.x), y.at(mark.y));
  return svg + "</svg>\n";
}

}  // namespace plumb
