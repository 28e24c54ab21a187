#include "report/study/stability/stability_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "render/gl/gl_context.h"
#include "report/study/panel_parts.h"
#include "report/study/stability/map_panel.h"
#include "report/study/stability/stability_results.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

std::vector<const OutcomeMap*> maps_over(const Stability& study, MapAxis axis, bool by_step) {
  std::vector<const OutcomeMap*> maps;
  for (const OutcomeMap& map : study.maps)
    if (map.axis == axis && map.by_step == by_step) maps.push_back(&map);
  return maps;
}

std::string axis_in_words(const Stability& study, MapAxis axis) {
  if (axis == MapAxis::parameter) return study.parameter;
  return axis == MapAxis::elements ? "elements" : "duration";
}

std::string counts_in_words(const std::vector<const OutcomeMap*>& maps) {
  Stability all;
  for (const OutcomeMap* map : maps) all.maps.push_back(*map);
  return outcomes_in_words(all);
}

/// A label without what the figure says of all its maps.
std::string without_kind(const std::string& label) {
  for (const std::string ending : {", fixed step", ", controlled step"})
    if (label.ends_with(ending)) return label.substr(0, label.size() - ending.size());
  return label;
}

Figure map_figure(const Stability& study, MapAxis axis, bool by_step) {
  const std::vector<const OutcomeMap*> maps = maps_over(study, axis, by_step);
  constexpr int most_columns = 4, row_height = 400, head = 260;
  Figure figure;
  figure.name = map_figure_name(axis, by_step);
  figure.title = fmt::format("Outcomes over {} and {} ({})", by_step ? "step" : "tolerance",
                             axis_in_words(study, axis), place_in_words(study, axis));
  const int columns = std::min(most_columns, static_cast<int>(maps.size()));
  const int rows = (static_cast<int>(maps.size()) + columns - 1) / columns;
  figure.plot.title = figure.title;
  figure.plot.columns = columns;
  figure.plot.width = 2400;
  figure.plot.height = head + rows * row_height;
  figure.plot.font_size = 30;
  figure.plot.key = map_key(maps);
  for (std::size_t k = 0; k < maps.size(); ++k)
    figure.plot.panels.push_back(map_panel(study, *maps[k], without_kind(maps[k]->label)));
  figure.alt = fmt::format("{} of outcomes, one a method, over {} from left to right and {} upwards: {}.",
                           counted(std::ssize(maps), "map", "maps"), by_step ? "step" : "tolerance",
                           axis_in_words(study, axis), counts_in_words(maps));
  return figure;
}

std::string file_name_of(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    if (plain)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

Color colour(std::size_t k) {
  return palette[k % palette.size()];
}

constexpr std::array<Marker, 5> markers{Marker::circle, Marker::square, Marker::diamond, Marker::triangle_up,
                                        Marker::triangle_down};

/// Critical steps over the parameter (all on the case's mesh) or over the elements (all at its value).
Panel limits_panel(const Stability& study, MapAxis axis) {
  const bool parameter = axis == MapAxis::parameter;
  Panel panel;
  panel.x = log_axis(parameter ? study.parameter : "elements");
  panel.y = log_axis("critical step [s]");
  std::map<std::string, std::pair<Series, Series>> lines;
  std::vector<std::string> order;
  for (const CriticalStep& step : study.critical_steps) {
    if (parameter ? step.elements != study.elements : step.parameter != study.parameter_value) continue;
    if (!lines.contains(step.label)) order.push_back(step.label);
    auto& [found, predicted] = lines[step.label];
    const double x = parameter ? step.parameter : step.elements;
    add_point(found, x, found_step(step));
    add_point(predicted, x, predicted_step(step));
    if (std::find(panel.x.ticks.begin(), panel.x.ticks.end(), x) == panel.x.ticks.end())
      panel.x.ticks.push_back(x);
  }
  std::sort(panel.x.ticks.begin(), panel.x.ticks.end());
  for (std::size_t k = 0; k < order.size(); ++k) {
    auto& [found, predicted] = lines[order[k]];
    for (Series* series : {&found, &predicted}) {
      std::vector<std::pair<double, double>> points;
      for (std::size_t i = 0; i < series->x.size(); ++i) points.emplace_back(series->x[i], series->y[i]);
      std::sort(points.begin(), points.end());
      for (std::size_t i = 0; i < points.size(); ++i) std::tie(series->x[i], series->y[i]) = points[i];
      series->color = colour(k);
    }
    found.label = order[k] + ", found";
    found.line_width = 0;
    found.marker = markers[k % markers.size()];
    found.marker_size = 1.3;
    predicted.label = order[k] + ", predicted";
    panel.series.push_back(predicted);
    panel.series.push_back(found);
  }
  return panel;
}

Figure limits_figure(const Stability& study) {
  Figure figure;
  figure.name = limits_figure_name;
  figure.title = "Critical steps, found and predicted";
  figure.plot.title = figure.title;
  figure.plot.width = 2000;
  figure.plot.height = 1000;
  figure.plot.columns = study.parameter.empty() ? 1 : 2;
  if (!study.parameter.empty()) {
    figure.plot.panels.push_back(limits_panel(study, MapAxis::parameter));
    figure.plot.panels.back().title = counted(study.elements, "element", "elements");
  }
  figure.plot.panels.push_back(limits_panel(study, MapAxis::elements));
  figure.plot.panels.back().title = parameter_text(study, study.parameter_value);
  figure.plot.panels.back().legend = study.parameter.empty();
  double worst = 0;
  for (const CriticalStep& step : study.critical_steps)
    if (const double off = deviation(step); !std::isnan(off)) worst = std::max(worst, std::abs(off));
  figure.alt = fmt::format(
      "Plot on logarithmic axes of the critical steps found by bisection, as points, and predicted from the "
      "fastest vibration, as lines. They differ by at most {:.2g} %.",
      100 * worst);
  return figure;
}

Figure energy_figure(const Stability& study) {
  Figure figure;
  figure.name = energy_history_figure_name;
  figure.title = fmt::format("Change of the total energy, step {:g} s", study.energies.front().step);
  figure.plot.title = figure.title;
  figure.plot.width = 2000;
  std::map<std::string, std::size_t> places;
  std::string ends;
  for (const EnergyHistory& history : study.energies) {
    const std::string title = parameter_text(study, history.parameter);
    if (figure.plot.panels.empty() || figure.plot.panels.back().title != title) {
      Panel panel;
      panel.title = title;
      panel.y.label = "change / first kinetic energy";
      panel.y.zero_line = true;
      panel.legend = figure.plot.panels.empty();
      panel.shares_x_below = true;
      figure.plot.panels.push_back(std::move(panel));
    }
    const std::size_t k = places.try_emplace(history.label, places.size()).first->second;
    Series series;
    series.label = without_kind(history.label);
    series.color = colour(k);
    series.dash = k < palette.size() ? Dash::solid : Dash::dashed;
    series.x = history.times;
    series.y = history.change;
    Panel& panel = figure.plot.panels.back();
    panel.series.push_back(series);
    if (is_stable(history.outcome) || history.outcome == Outcome::completed || history.times.empty())
      continue;
    // Where it ended, so that the end of a line is no accident.
    Series end;
    end.color = series.color;
    end.line_width = 0;
    end.marker = Marker::cross;
    end.marker_size = 1.4;
    add_point(end, history.times.back(), history.change.back());
    panel.series.push_back(std::move(end));
    ends += fmt::format(" {}{}{} ended {} at {:.3g} s.", history.label, title.empty() ? "" : " at ", title,
                        word(history.outcome), history.times.back());
  }
  for (Panel& panel : figure.plot.panels) {
    Axis& axis = panel.y;
    double lo = 0, hi = 0;
    for (const Series& series : panel.series)
      for (const double value : series.y)
        if (std::isfinite(value)) {
          lo = std::min(lo, value);
          hi = std::max(hi, value);
        }
    // What blows up shows that it does; the others must show how they differ.
    axis.range = {std::max(-0.1, lo - 0.05), std::clamp(1.1 * hi, 0.1, 1.5)};
  }
  figure.plot.panels.back().x.label = "time [s]";
  figure.plot.panels.back().shares_x_below = false;
  figure.plot.height = 500 + 650 * static_cast<int>(figure.plot.panels.size());
  figure.alt =
      "Plot of the change of the total energy over time as a share of the first kinetic energy, a "
      "line a method; crosses mark where runs ended." +
      ends;
  return figure;
}

Figure amplification_figure(const Stability& study) {
  Panel panel;
  panel.x = log_axis("steps a period");
  panel.y.label = "amplitude after a period / before";
  std::map<std::string, std::size_t> places;
  std::vector<Series> lines, points;
  double off = 0, greatest = 1;
  for (const ModeAmplification& mode : study.amplifications) {
    const auto [place, fresh] = places.try_emplace(mode.label, places.size());
    const std::size_t k = place->second;
    if (fresh) {
      Series& line = lines.emplace_back();
      line.label = without_kind(mode.label);
      line.color = colour(k);
      line.dash = k < palette.size() ? Dash::solid : k < 2 * palette.size() ? Dash::dashed : Dash::dotted;
      line.line_width = 0.7;
      Series& point = points.emplace_back();
      point.color = line.color;
      point.line_width = 0;
      point.marker = markers[k % markers.size()];
      line.marker = Marker::none;
    }
    add_point(lines[k], mode.steps_a_period, mode.predicted);
    if (mode.measured >= 0) {
      add_point(points[k], mode.steps_a_period, mode.measured);
      off = std::max(off, std::abs(mode.measured - mode.predicted) / std::max(1.0, mode.predicted));
    }
    if (std::find(panel.x.ticks.begin(), panel.x.ticks.end(), mode.steps_a_period) == panel.x.ticks.end())
      panel.x.ticks.push_back(mode.steps_a_period);
    greatest = std::max(greatest, mode.predicted);
  }
  std::sort(panel.x.ticks.begin(), panel.x.ticks.end());
  panel.y.range = {-0.05, std::clamp(1.05 * greatest, 1.1, 2.0)};
  panel.series = std::move(lines);
  panel.series.insert(panel.series.end(), points.begin(), points.end());
  Figure figure;
  figure.name = amplification_figure_name;
  figure.title = "What a period of the fastest vibration leaves of its amplitude";
  figure.plot.title = figure.title;
  figure.plot.width = 2000;
  figure.plot.height = 1600;
  figure.plot.font_size = 32;
  figure.plot.panels.push_back(std::move(panel));
  figure.alt = fmt::format(
      "Plot of the amplification of one vibration in a period over the steps a period: lines by theory, "
      "points as measured. They differ by at most {:.2g}.",
      off);
  return figure;
}

Figure separation_figure(const Stability& study) {
  Figure figure;
  figure.name = separation_figure_name;
  figure.title = "How fast neighbouring motions part";
  figure.plot.title = figure.title;
  figure.plot.width = 2000;
  figure.plot.height = 1100;
  Panel by_parameter, by_elements;
  by_parameter.title = counted(study.elements, "element", "elements");
  by_elements.title = parameter_text(study, study.parameter_value);
  std::string words;
  std::vector<TrajectoryDivergence> sorted = study.divergences;
  std::stable_sort(
      sorted.begin(), sorted.end(),
      [](const TrajectoryDivergence& a, const TrajectoryDivergence& b) { return a.elements < b.elements; });
  for (const TrajectoryDivergence& divergence : sorted) {
    Series series;
    series.x = divergence.times;
    series.y = divergence.distances;
    const auto put = [&](Panel& panel, const std::string& label) {
      const std::size_t k = panel.series.size();
      series.label = label;
      series.color = colour(k);
      series.dash = k < palette.size() ? Dash::solid : Dash::dashed;
      panel.series.push_back(series);
    };
    const bool own = divergence.elements == study.elements && divergence.parameter == study.parameter_value;
    if (!study.parameter.empty() && divergence.elements == study.elements)
      put(by_parameter, parameter_text(study, divergence.parameter));
    if (own || divergence.elements != study.elements || study.parameter.empty())
      put(by_elements, counted(divergence.elements, "element", "elements"));
    words += " " + divergence.in_words;
  }
  for (Panel* panel : {&by_parameter, &by_elements}) {
    panel->x.label = "time [s]";
    panel->y = log_axis("distance [m]");
    Rule tolerance;
    tolerance.from = tolerance.to = study.tolerance;
    tolerance.label = "tolerance";
    tolerance.dash = Dash::dashed;
    panel->rules.push_back(tolerance);
    if (!panel->series.empty()) figure.plot.panels.push_back(*panel);
  }
  figure.plot.columns = static_cast<int>(figure.plot.panels.size());
  figure.alt = "Plot of the distance of two neighbouring starts over time, on a logarithmic axis." + words;
  return figure;
}

}  // namespace

std::string map_figure_name(MapAxis axis, bool by_step) {
  return fmt::format("stability_{}{}", word(axis), by_step ? "" : "_tolerance");
}

std::vector<Figure> stability_figures(const Stability& study) {
  std::vector<Figure> figures;
  for (const MapAxis axis : {MapAxis::parameter, MapAxis::elements, MapAxis::duration})
    for (const bool by_step : {true, false})
      if (!maps_over(study, axis, by_step).empty()) figures.push_back(map_figure(study, axis, by_step));
  if (!study.critical_steps.empty()) figures.push_back(limits_figure(study));
  if (!study.energies.empty()) figures.push_back(energy_figure(study));
  if (!study.amplifications.empty()) figures.push_back(amplification_figure(study));
  if (!study.divergences.empty()) figures.push_back(separation_figure(study));
  return figures;
}

std::vector<Figure> method_figures(const Stability& study) {
  std::vector<Figure> figures;
  for (const OutcomeMap& map : study.maps) {
    if (figures.empty() || figures.back().title != map.label) {
      Figure& figure = figures.emplace_back();
      figure.title = map.label;
      figure.name = "stability_" + file_name_of(map.label);
      figure.plot.title = map.label;
      figure.plot.width = 1600;
      figure.alt = "Maps of outcomes.";
    }
    Plot& plot = figures.back().plot;
    plot.panels.push_back(map_panel(study, map, place_in_words(study, map.axis)));
    plot.height = 250 + 650 * static_cast<int>(plot.panels.size());
    figures.back().alt += fmt::format(" Over {}: {}.", axis_in_words(study, map.axis), map.in_words);
  }
  for (Figure& figure : figures) {
    std::vector<const OutcomeMap*> maps;
    for (const OutcomeMap& map : study.maps)
      if (map.label == figure.title) maps.push_back(&map);
    figure.plot.key = map_key(maps);
  }
  return figures;
}

}  // namespace plumb
