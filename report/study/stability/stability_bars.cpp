#include "report/study/stability/stability_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/study/stability/step_in_words.h"
#include "render/plot/cell_grid.h"
#include "report/base/escape.h"
#include "report/figure/curve_style.h"
#include "report/figure/outcome_style.h"
#include "report/study/method_label.h"
#include "report/study/stability/map_panel.h"
#include "report/study/stability/stability_conclusion.h"
#include "report/study/stability/stability_results.h"

namespace plumb {
namespace {

constexpr std::size_t most_values = 12;

/// Values of the axis that is told, the case's own and others evenly among the rest, rising.
std::vector<double> shown_values(const Stability& study, ToldPlace own) {
  std::vector<double> values;
  for (const OutcomeMap& map : study.maps)
    if (map.axis == own.axis) values.insert(values.end(), map.values.begin(), map.values.end());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.size() <= most_values) return values;
  std::vector<double> some{own.value};
  for (std::size_t k = 0; k + 1 < most_values; ++k)
    some.push_back(values[k * (values.size() - 1) / (most_values - 2)]);
  std::sort(some.begin(), some.end());
  some.erase(std::unique(some.begin(), some.end()), some.end());
  return some;
}

/// Percent of the width of a bar at a setting.
class BarAxis {
 public:
  BarAxis(const Stability& study, bool by_step) {
    for (const OutcomeMap& map : study.maps) {
      if (map.by_step != by_step || map.settings.empty()) continue;
      const std::vector<double> edges = edges_between(map.settings);
      from_ = std::min(from_, std::log10(edges.front()));
      to_ = std::max(to_, std::log10(edges.back()));
    }
  }

  double at(double setting) const { return 100 * (std::log10(setting) - from_) / (to_ - from_); }
  bool holds(double setting) const {
    return setting > 0 && std::isfinite(setting) && at(setting) >= 0 && at(setting) <= 100;
  }
  /// Exponents of the powers of ten on it.
  std::vector<int> decades() const {
    std::vector<int> all;
    const int first = static_cast<int>(std::ceil(from_)), last = static_cast<int>(std::floor(to_));
    // No more than there is room for on a telephone.
    const int every = std::max(1, (last - first + 5) / 6);
    for (int k = first; k <= last; k += every) all.push_back(k);
    return all;
  }

 private:
  double from_ = std::numeric_limits<double>::infinity(), to_ = -from_;
};

std::string grid_of(const BarAxis& axis) {
  std::string svg;
  for (const int k : axis.decades()) {
    const double x = axis.at(std::pow(10.0, k));
    svg += fmt::format(R"(<line class="grid" x1="{0:.2f}%" x2="{0:.2f}%" y1="0" y2="100%"/>)", x);
  }
  return svg;
}

std::string scale_of(const BarAxis& axis, bool by_step) {
  std::string svg;
  for (const int k : axis.decades()) {
    const double x = axis.at(std::pow(10.0, k));
    const char* anchor = x < 4 ? "start" : x > 96 ? "end" : "middle";
    svg += fmt::format(
        R"(<text x="{:.2f}%" y="14" text-anchor="{}">10<tspan dy="-5" font-size="10">{}{}</tspan></text>)", x,
        anchor, k < 0 ? "−" : "", std::abs(k));
  }
  return fmt::format(R"(<li class="scale" aria-hidden="true"><span>{}</span><svg height="18">{}</svg></li>)",
                     by_step ? "step [s]" : "rtol", svg);
}

/// Neighbours of one outcome are one part of a bar.
std::string parts_of(const BarAxis& axis, const MethodReach& reach) {
  const OutcomeMap& map = *reach.map;
  const std::size_t n = map.settings.size();
  const std::vector<double> edges = edges_between(map.settings);
  std::string svg;
  for (std::size_t from = 0, to = 0; from < n; from = to) {
    const int place = outcome_place(map.points[reach.at * n + from].outcome);
    while (to < n && outcome_place(map.points[reach.at * n + to].outcome) == place) ++to;
    if (place < 0) continue;
    const OutcomeStyle& style = outcome_styles()[static_cast<std::size_t>(place)];
    const double x = axis.at(edges[from]), width = axis.at(edges[to]) - x;
    svg += fmt::format(R"(<rect x="{:.2f}%" y="2" width="{:.2f}%" height="16" fill="{}"/>)", x, width,
                       css(style.color));
    constexpr double room_for_letter = 4;
    if (!style.letter.empty() && width >= room_for_letter)
      svg += fmt::format(R"(<text x="{:.2f}%" y="14" text-anchor="middle" fill="{}">{}</text>)",
                         x + width / 2, css(ink_on(style.color)), style.letter);
  }
  return svg;
}

/// The critical step of the same method and place; -1: none was found.
double found_at(const Stability& study, const MethodReach& reach, ToldPlace place) {
  const double parameter = place.axis == MapAxis::parameter ? place.value : study.parameter_value;
  const auto elements =
      place.axis == MapAxis::elements ? static_cast<int>(std::lround(place.value)) : study.elements;
  for (const CriticalStep& step : study.critical_steps)
    if (step.label == reach.map->label && step.parameter == parameter && step.elements == elements)
      return found_step(step);
  return -1;
}

std::string marks_of(const Stability& study, const BarAxis& axis, const MethodReach& reach, ToldPlace place) {
  std::string svg;
  const OutcomeMap& map = *reach.map;
  if (reach.at < map.limits.size()) {
    const PredictedLimit& limit = map.limits[reach.at];
    const double step = limit.at_worst > 0 ? limit.at_worst : limit.at_start;
    if (axis.holds(step))
      svg += fmt::format(
          R"(<line class="halo" x1="{0:.2f}%" x2="{0:.2f}%" y1="0" y2="20"/><line class="limit{1}" x1="{0:.2f}%" x2="{0:.2f}%" y1="0" y2="20"/>)",
          axis.at(step), map.limit_kind == LimitKind::contraction ? " contraction" : "");
  }
  if (const double found = found_at(study, reach, place); axis.holds(found))
    svg += fmt::format(R"(<circle class="found" cx="{:.2f}%" cy="10" r="4"/>)", axis.at(found));
  return svg;
}

std::string reach_text(const MethodReach& reach, bool by_step) {
  const auto text = [&](double setting) { return setting_text(setting) + (by_step ? " s" : ""); };
  if (reach.accurate_from == reach.accurate && reach.accurate > 0)
    return "accurate at " + text(reach.accurate);
  if (reach.accurate_from > 0)
    return fmt::format("{} to {}", setting_text(reach.accurate_from), text(reach.accurate));
  if (reach.accurate > 0) return "accurate to " + text(reach.accurate);
  if (reach.stable_from > 0)
    return fmt::format("stable only {} to {}", setting_text(reach.stable_from), text(reach.stable));
  return reach.stable > 0 ? "stable to " + text(reach.stable) : std::string("never stable");
}

std::string list_of(const Stability& study, ToldPlace place, bool by_step) {
  const std::vector<MethodReach> reaches = reaches_at(study, place, by_step);
  if (reaches.empty()) return "";
  const BarAxis axis(study, by_step);
  std::string html = fmt::format("<ul class=\"bar-list\">\n{}\n", scale_of(axis, by_step));
  for (const MethodReach& reach : reaches)
    html += fmt::format(
        R"(<li><span class="bar-label">{}</span><svg height="20" role="img" aria-label="{}">{}{}{}</svg><span class="bar-reach">{}</span></li>)"
        "\n",
        escape_xml(label_in_sentence(reach.map->label)), escape_xml(step_in_words(*reach.map, reach.at)),
        grid_of(axis), parts_of(axis, reach), marks_of(study, axis, reach, place),
        reach_text(reach, by_step));
  return html + "</ul>\n";
}

}  // namespace

std::string stability_bars(const Stability& study) {
  const ToldPlace own = own_place(study);
  const std::vector<double> values = shown_values(study, own);
  std::string inputs, panes;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ToldPlace place{own.axis, values[k]};
    inputs += fmt::format(
        R"(<input type="radio" name="bars" id="bars-{0}"{1}><label for="bars-{0}">{2}{3}</label>)"
        "\n",
        k, values[k] == own.value ? " checked" : "", escape_xml(value_text(study, own.axis, values[k])),
        values[k] == own.value ? ", the case" : "");
    panes += "<div>\n" + list_of(study, place, true);
    if (const std::string tolerances = list_of(study, place, false); !tolerances.empty())
      panes += "<p>Methods that choose their steps, over the tolerance:</p>\n" + tolerances;
    panes += "</div>\n";
  }
  return fmt::format("<div class=\"bars\" role=\"group\" aria-label=\"Which step, by method\">\n{}{}</div>\n",
                     values.size() > 1 ? inputs : "", panes);
}

std::string stability_bars_css(const Stability& study) {
  const std::size_t count = shown_values(study, own_place(study)).size();
  if (count < 2) return "";
  std::string css = ".bars > div { display: none; }\n";
  for (std::size_t k = 1; k <= count; ++k)
    css += fmt::format(
        ".bars > input:nth-of-type({0}):checked ~ div:nth-of-type({0}) {{ display: block; }}\n", k);
  return css;
}

}  // namespace plumb
