#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/study/stability/step_in_words.h"
#include "render/plot/cell_grid.h"
#include "report/figure/curve_style.h"
#include "report/figure/outcome_style.h"
#include "report/page/page_template.h"
#include "report/study/stability/stability_bars.h"
#include "report/study/stability/stability_conclusion.h"
#include "report/study/stability/stability_figures.h"
#include "report/study/stability/stability_map_data.h"
#include "report/study/stability/stability_results.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view stability_mustache;
extern const std::string_view stability_css;
extern const std::string_view stability_js;
extern const std::string_view stability_js_sha256;

namespace {

using kainjow::mustache::data;

std::string four_digits(double value) {
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  return std::isnan(value) ? "–" : fmt::format("{:.4g}", value);
}

/// A step, or another number that is -1 where it is not known.
std::string step_text(double value) {
  return value < 0 ? "–" : std::isinf(value) ? "none" : setting_text(value, 4);
}

std::string share(double value) {
  return std::isfinite(value) ? fmt::format("{:+.3g}", value) : four_digits(value);
}

void set_picture(data& values, const std::string& key, const std::vector<Picture>& pictures,
                 const std::string& name) {
  if (const Picture* picture = find_picture(pictures, name)) values.set(key, picture_values(*picture));
}

std::string summary(const Stability& study) {
  const std::string own = parameter_text(study, study.parameter_value);
  return fmt::format(
      "Every method over steps, or over tolerances where it chooses its steps, and over {}the number of "
      "elements and the duration, around the case itself: {}{}, {:g} s. A run is accurate where no node is "
      "ever further than {:g} m from the exact motion of the same mesh: it is the method that is in question "
      "here, not the mesh.",
      study.parameter.empty() ? "" : fmt::format("the parameter {}, ", study.parameter), own,
      (own.empty() ? "" : ", ") + counted(study.elements, "element", "elements"), study.end, study.tolerance);
}

/// The places of a map's values that the table of words has: the first, the case's own, and the last.
std::vector<std::size_t> told_places(const Stability& study, const OutcomeMap& map) {
  std::vector<std::size_t> places{0};
  for (std::size_t k = 1; k + 1 < map.values.size(); ++k)
    if (map.axis == MapAxis::parameter ? map.values[k] == study.parameter_value
                                       : map.values[k] == study.elements)
      places.push_back(k);
  if (map.values.size() > 1) places.push_back(map.values.size() - 1);
  return places;
}

/// In words for each method, over the parameter or, where none is varied, over the elements.
void set_words(data& values, const Stability& study) {
  const MapAxis axis = study.parameter.empty() ? MapAxis::elements : MapAxis::parameter;
  data columns{data::type::list}, rows{data::type::list};
  bool first = true;
  for (const OutcomeMap& map : study.maps) {
    if (map.axis != axis) continue;
    data row, cells{data::type::list};
    row["label"] = map.label;
    for (const std::size_t at : told_places(study, map)) {
      if (first) columns.push_back(data{"text", value_text(study, axis, map.values[at])});
      data cell;
      cell["at"] = value_text(study, axis, map.values[at]);
      cell["text"] = step_in_words(map, at);
      cells.push_back(cell);
    }
    first = false;
    row.set("cells", cells);
    rows.push_back(row);
  }
  const ToldPlace own = own_place(study);
  values["bars_intro"] = fmt::format(
      "What became of every run, {}, sorted by the longest step that stays accurate to {:g} m. A run stands "
      "for "
      "the settings half way to its neighbours.",
      place_in_words(study, own.axis), study.tolerance);
  values["words_intro"] =
      fmt::format("The steps that a user would want, from the maps over {}: {}.",
                  axis == MapAxis::parameter ? study.parameter : "the elements", place_in_words(study, axis));
  values.set("own_columns", columns);
  values.set("words", rows);
}

void set_maps(data& values, const Stability& study, const std::vector<Picture>& pictures) {
  const bool all = std::all_of(study.divergences.begin(), study.divergences.end(),
                               [](const TrajectoryDivergence& s) { return s.beyond_end; });
  values["judged"] = all ? "All are judged to their end, as neighbouring motions stay together."
                         : "Where neighbouring motions part, a run is judged up to there, and beyond it by "
                           "its energy alone.";
  data outcomes{data::type::list};
  for (const OutcomeStyle& style : outcome_styles()) {
    const auto has = [&](const OutcomeMap& map) {
      return std::any_of(map.points.begin(), map.points.end(),
                         [&](const StabilityPoint& point) { return point.outcome == style.outcome; });
    };
    if (std::none_of(study.maps.begin(), study.maps.end(), has)) continue;
    data entry;
    entry["color"] = css(style.color);
    entry["ink"] = css(ink_on(style.color));
    entry["letter"] = style.letter.empty() ? " " : style.letter;
    entry["name"] = std::string(word(style.outcome));
    entry["meaning"] = style.meaning;
    outcomes.push_back(entry);
  }
  values.set("outcomes", outcomes);
  data drawn{data::type::list};
  for (const MapAxis axis : {MapAxis::parameter, MapAxis::elements, MapAxis::duration})
    for (const bool by_step : {true, false})
      if (const Picture* picture = find_picture(pictures, map_figure_name(axis, by_step)))
        drawn.push_back(picture_values(*picture));
  values.set("map_pictures", drawn);
}

data limit_rows(const Stability& study) {
  data rows{data::type::list};
  for (const CriticalStep& step : study.critical_steps) {
    const double off = deviation(step);
    data row;
    row["label"] = step.label;
    row["value"] = fmt::format("{:g}", step.parameter);
    row["elements"] = std::to_string(step.elements);
    row["stable"] = step_text(step.stable);
    row["unstable"] = step_text(step.unstable);
    row["start"] = step_text(step.predicted.at_start);
    row["worst"] = step_text(step.predicted.at_worst);
    row["deviation"] = std::isnan(off) ? "–" : fmt::format("{:+.1f} %", 100 * off);
    row["beyond"] = step.unstable > 0 ? std::string(word(step.beyond)) : "–";
    rows.push_back(row);
  }
  return rows;
}

data energy_rows(const Stability& study) {
  data rows{data::type::list};
  for (const EnergyHistory& history : study.energies) {
    data row;
    row["label"] = history.label;
    row["value"] = fmt::format("{:g}", history.parameter);
    row["outcome"] = std::string(word(history.outcome));
    row["end"] = history.times.empty() ? "–" : fmt::format("{:.3g}", history.times.back());
    row["gain"] =
        history.change.empty() ? "–" : share(*std::max_element(history.change.begin(), history.change.end()));
    row["last"] = history.change.empty() ? "–" : share(history.change.back());
    row["message"] = history.message;
    rows.push_back(row);
  }
  return rows;
}

data amplification_rows(const Stability& study) {
  data rows{data::type::list};
  for (const ModeAmplification& mode : study.amplifications) {
    data row;
    row["label"] = mode.label;
    row["steps"] = fmt::format("{:g}", mode.steps_a_period);
    row["measured"] = mode.measured < 0 ? "–" : fmt::format("{:.6g}", mode.measured);
    row["predicted"] = fmt::format("{:.6g}", mode.predicted);
    row["difference"] = mode.measured < 0 ? "–" : fmt::format("{:.1e}", mode.measured - mode.predicted);
    rows.push_back(row);
  }
  return rows;
}

data separation_rows(const Stability& study) {
  data rows{data::type::list};
  for (std::size_t k = 0; k < std::min(study.divergences.size(), study.references.size()); ++k) {
    const TrajectoryDivergence& divergence = study.divergences[k];
    const StabilityReference& reference = study.references[k];
    data row;
    row["value"] = fmt::format("{:g}", divergence.parameter);
    row["elements"] = std::to_string(divergence.elements);
    row["exponent"] = four_digits(divergence.exponent);
    row["horizon"] = divergence.horizon < 0 && !divergence.beyond_end ? "–"
                     : divergence.beyond_end ? fmt::format("beyond {:g} s", reference.duration)
                                             : fmt::format("{:.3g} s", divergence.horizon);
    row["trusted"] = step_text(reference.trusted_until);
    row["agreement"] = reference.agreement < 0 ? "–" : fmt::format("{:.1e}", reference.agreement);
    row["start"] = four_digits(reference.frequency_at_start);
    row["worst"] = four_digits(reference.frequency_at_worst);
    rows.push_back(row);
  }
  return rows;
}

std::string horizon_words(const Stability& study) {
  std::string early;
  for (const TrajectoryDivergence& divergence : study.divergences)
    if (!divergence.beyond_end && divergence.horizon >= 0) {
      const std::string value = parameter_text(study, divergence.parameter);
      early += fmt::format("{}{}{}{} until {:.3g} s", early.empty() ? "" : ", ", value,
                           value.empty() ? "" : " with ", counted(divergence.elements, "element", "elements"),
                           divergence.horizon);
    }
  const std::string why =
      " Two starts that nobody could tell apart are followed until they are further from one another than "
      "the tolerance: from that time on, a trajectory says which of them was started from, and round-off "
      "decides. No method can be held against another there, however exact both are.";
  if (early.empty())
    return "Comparing trajectories means something throughout: no neighbouring motions part by as much as "
           "the tolerance." +
           why;
  return fmt::format(
      "Comparing trajectories means something for {}; elsewhere throughout.{} Beyond the horizon energies "
      "and statistics are compared instead, as these do not depend on which of the neighbours a run follows: "
      "the energy must stay as it is whatever the motion, and means must agree as those of two neighbours "
      "do.",
      early, why);
}

data statistics_rows(const Stability& study) {
  data rows{data::type::list};
  for (const MotionStatistics& one : study.statistics) {
    data row;
    row["value"] = fmt::format("{:g}", one.parameter);
    row["label"] = one.step > 0 ? fmt::format("{}, step {:g} s", one.label, one.step) : one.label;
    row["taken"] = one.taken;
    row["height"] = fmt::format("{:.3f}", one.mean_height);
    row["deviation"] = fmt::format("{:.3f}", one.height_deviation);
    row["speed"] = fmt::format("{:.3f}", one.rms_speed);
    row["energy"] = fmt::format("{:+.1e}", one.energy_change);
    row["outcome"] = std::string(word(one.outcome));
    row["duration"] = fmt::format("{:g}", one.duration);
    rows.push_back(row);
  }
  return rows;
}

/// Points that did not complete, by method and outcome.
data failure_rows(const Stability& study, long& failures) {
  struct Group {
    const OutcomeMap* map;
    std::size_t at;
    long count;
  };
  data rows{data::type::list};
  std::vector<std::string> labels;
  for (const OutcomeMap& map : study.maps)
    if (std::find(labels.begin(), labels.end(), map.label) == labels.end()) labels.push_back(map.label);
  for (const std::string& label : labels)
    for (const OutcomeStyle& style : outcome_styles()) {
      Group group{nullptr, 0, 0};
      for (const OutcomeMap& map : study.maps) {
        if (map.label != label) continue;
        const std::size_t n = map.settings.size();
        for (std::size_t k = 0; k < map.points.size(); ++k) {
          if (map.points[k].outcome != style.outcome || map.points[k].message.empty()) continue;
          ++group.count;
          if (!group.map || map.settings[k % n] < group.map->settings[group.at % n]) {
            group.map = &map;
            group.at = k;
          }
        }
      }
      if (!group.map) continue;
      const std::size_t n = group.map->settings.size();
      data row;
      row["label"] = label;
      row["outcome"] = std::string(word(style.outcome));
      row["count"] = std::to_string(group.count);
      row["where"] =
          fmt::format("{} {}{}, {}", group.map->by_step ? "step" : "rtol",
                      setting_text(group.map->settings[group.at % n]), group.map->by_step ? " s" : "",
                      value_text(study, group.map->axis, group.map->values[group.at / n]));
      row["message"] = group.map->points[group.at].message;
      rows.push_back(row);
      failures += group.count;
    }
  return rows;
}

std::string section_html(const Stability& study, const std::vector<Picture>& pictures) {
  data values;
  values["summary"] = summary(study);
  values["has_parameter"] = !study.parameter.empty();
  values["parameter"] = study.parameter;
  values["bars"] = stability_bars(study);
  set_words(values, study);
  set_maps(values, study, pictures);
  values["has_limits"] = !study.critical_steps.empty();
  values["limits"] = limit_rows(study);
  set_picture(values, "limits_picture", pictures, limits_figure_name);
  values["has_energies"] = !study.energies.empty();
  values["energies"] = energy_rows(study);
  set_picture(values, "energy_picture", pictures, energy_history_figure_name);
  values["has_amplifications"] = !study.amplifications.empty();
  values["amplifications"] = amplification_rows(study);
  set_picture(values, "amplification_picture", pictures, amplification_figure_name);
  values["has_separations"] = !study.divergences.empty();
  values["separations"] = separation_rows(study);
  values["has_statistics"] = !study.statistics.empty();
  values["statistics"] = statistics_rows(study);
  values["horizon_words"] = horizon_words(study);
  set_picture(values, "separation_picture", pictures, separation_figure_name);
  long failures = 0;
  values["failures"] = failure_rows(study, failures);
  values["has_failures"] = failures > 0;
  values["failure_count"] = counted(failures, "point", "points");
  return fill_in(stability_mustache, values);
}

}  // namespace

StudySection shown_stability(const Stability& study, const std::vector<Picture>& pictures) {
  StudySection section;
  section.links = {{"stability-words", "Which step?"}, {"stability-maps", "Maps"}};
  if (!study.critical_steps.empty()) section.links.emplace_back("stability-limits", "Critical steps");
  if (!study.energies.empty()) section.links.emplace_back("stability-energy", "Energy");
  if (!study.amplifications.empty()) section.links.emplace_back("stability-amplification", "One vibration");
  if (!study.divergences.empty()) section.links.emplace_back("stability-separation", "Horizon");
  section.links.emplace_back("stability-failures", "Failures");
  section.html = section_html(study, pictures);
  section.css = std::string(stability_css) + stability_bars_css(study);
  section.data = data_element("stability-data", stability_map_data(study));
  section.scripts = {{stability_js, stability_js_sha256}};
  section.verdict_note =
      "All are <strong>verification</strong>: of the predicted limits by the steps found, and of the "
      "references.";
  return section;
}

}  // namespace plumb
