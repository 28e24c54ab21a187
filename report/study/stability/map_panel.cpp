#include "report/study/stability/map_panel.h"

#include <algorithm>
#include <cmath>

#include "report/figure/outcome_style.h"

namespace plumb {
namespace {

constexpr Color limit_color = Color::hex(0x000000);

/// As a list of equal heights where a value has no place on a logarithmic axis.
bool all_positive(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value > 0; });
}

Series limit_line(bool worst) {
  Series line;
  line.label = worst ? "predicted limit, worst state" : "predicted limit, start";
  line.color = limit_color;
  line.dash = worst ? Dash::solid : Dash::dotted;
  return line;
}

bool has_limits(const OutcomeMap& map) {
  return map.limits.size() == map.values.size() &&
         std::any_of(map.limits.begin(), map.limits.end(), [](const PredictedLimit& limit) {
           return std::isfinite(limit.at_worst) && limit.at_worst > 0;
         });
}

}  // namespace

std::vector<double> edges_between(const std::vector<double>& values) {
  constexpr double alone = 1.5;
  const std::size_t n = values.size();
  std::vector<double> edges(n + 1);
  for (std::size_t k = 1; k < n; ++k) edges[k] = std::sqrt(values[k - 1] * values[k]);
  edges[0] = n > 1 ? values[0] * values[0] / edges[1] : values[0] / alone;
  edges[n] = n > 1 ? values[n - 1] * values[n - 1] / edges[n - 1] : values[0] * alone;
  return edges;
}

Panel map_panel(const Stability& study, const OutcomeMap& map, const std::string& title) {
  Panel panel;
  panel.title = title;
  panel.legend = false;
  CellGrid cells;
  cells.x_edges = edges_between(map.settings);
  const bool logarithmic = all_positive(map.values);
  if (logarithmic) {
    cells.y_edges = edges_between(map.values);
  } else {
    for (std::size_t k = 0; k <= map.values.size(); ++k)
      cells.y_edges.push_back(static_cast<double>(k) + 0.5);
  }
  for (const StabilityPoint& point : map.points) cells.categories.push_back(outcome_place(point.outcome));

  panel.x.label = map.by_step ? "step [s]" : "rtol";
  panel.x.scale = Scale::logarithmic;
  panel.x.range = {cells.x_edges.front(), cells.x_edges.back()};
  panel.y.label = map.axis == MapAxis::parameter  ? study.parameter
                  : map.axis == MapAxis::elements ? "elements"
                                                  : "duration [s]";
  panel.y.scale = logarithmic ? Scale::logarithmic : Scale::linear;
  panel.y.range = {cells.y_edges.front(), cells.y_edges.back()};
  panel.y.ticks = map.values;
  if (!logarithmic) {
    panel.y.label += " (by place)";
    for (std::size_t k = 0; k < map.values.size(); ++k) panel.y.ticks[k] = static_cast<double>(k) + 1;
  }
  if (has_limits(map)) {
    for (const bool worst : {false, true}) {
      Series line = limit_line(worst);
      line.label.clear();
      for (std::size_t k = 0; k < map.values.size(); ++k) {
        // Across the whole height of the value's cells, as a stair.
        const double step = worst ? map.limits[k].at_worst : map.limits[k].at_start;
        for (const std::size_t edge : {k, k + 1}) {
          line.x.push_back(std::isfinite(step) && step > 0 ? step : -1);
          line.y.push_back(cells.y_edges[edge]);
        }
      }
      panel.series.push_back(std::move(line));
    }
  }
  panel.cells = std::move(cells);
  return panel;
}

PlotKey map_key(const std::vector<const OutcomeMap*>& maps) {
  PlotKey key;
  const auto occurs = [&](Outcome outcome) {
    return std::any_of(maps.begin(), maps.end(), [&](const OutcomeMap* map) {
      return std::any_of(map->points.begin(), map->points.end(),
                         [&](const StabilityPoint& point) { return point.outcome == outcome; });
    });
  };
  // All of them keep their places; those that do not occur are not explained.
  for (const OutcomeStyle& style : outcome_styles())
    key.categories.push_back(
        {occurs(style.outcome) ? std::string(word(style.outcome)) : "", style.letter, style.color});
  if (std::any_of(maps.begin(), maps.end(), [](const OutcomeMap* map) { return has_limits(*map); }))
    key.lines = {limit_line(true), limit_line(false)};
  return key;
}

}  // namespace plumb
