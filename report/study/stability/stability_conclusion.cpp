#include "report/study/stability/stability_conclusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/study/stability/step_in_words.h"
#include "report/study/method_label.h"
#include "report/study/stability/stability_results.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

constexpr std::size_t most_named = 3;

/// "a, b and 4 more".
std::string some_of(std::vector<std::string> names) {
  if (names.size() > most_named + 1) {
    const std::string rest = fmt::format("{} more", names.size() - most_named);
    names.resize(most_named);
    names.push_back(rest);
  }
  return listed(names);
}

bool has_place(const OutcomeMap& map, ToldPlace place) {
  return map.axis == place.axis &&
         std::find(map.values.begin(), map.values.end(), place.value) != map.values.end();
}

/// Out of time is slow, and what could not be judged is not known.
bool is_failure(Outcome outcome) {
  return !is_stable(outcome) && outcome != Outcome::out_of_time && outcome != Outcome::completed &&
         outcome != Outcome::not_run;
}

MethodReach reach_of(const OutcomeMap& map, double value) {
  MethodReach reach;
  reach.map = &map;
  reach.at =
      static_cast<std::size_t>(std::find(map.values.begin(), map.values.end(), value) - map.values.begin());
  const SettingStretch accurate = accurate_stretch(map, reach.at), stable = stable_stretch(map, reach.at);
  if (!accurate.empty()) reach.accurate = map.settings[accurate.to - 1];
  if (!accurate.empty() && accurate.from > 0) reach.accurate_from = map.settings[accurate.from];
  if (!stable.empty()) reach.stable = map.settings[stable.to - 1];
  if (!stable.empty() && stable.from > 0) reach.stable_from = map.settings[stable.from];
  const std::size_t n = map.settings.size();
  for (std::size_t k = 0; k < n && reach.fails < 0; ++k) {
    const Outcome outcome = map.points[reach.at * n + k].outcome;
    if (!is_failure(outcome)) continue;
    reach.fails = map.settings[k];
    reach.then = outcome;
  }
  return reach;
}

std::string with_unit(double setting, bool by_step) {
  return by_step ? setting_text(setting) + " s" : setting_text(setting);
}

/// The methods that are first in the order of reaches_at(), as far as they are alike; `greatest`: what they
/// bear is the greatest that was tried.
std::string best_in_words(const std::vector<MethodReach>& reaches, bool by_step, double tolerance) {
  const MethodReach& best = reaches.front();
  const std::string what = by_step ? "step" : "tolerance";
  if (best.accurate < 0)
    return fmt::format("no method is accurate to {:g} m with any {} that was tried", tolerance, what);
  std::vector<std::string> names;
  for (const MethodReach& reach : reaches)
    if (reach.accurate == best.accurate) names.push_back(label_in_sentence(reach.map->label));
  const bool greatest = best.accurate == best.map->settings.back();
  const std::string reach =
      fmt::format("accurate to {:g} m up to {} {}{}", tolerance, by_step ? "a step of" : "rtol",
                  with_unit(best.accurate, by_step), greatest ? ", the greatest that was tried" : "");
  if (reaches.size() == 1) return fmt::format("{}, the only method, stays {}", names.front(), reach);
  if (names.size() == reaches.size()) return fmt::format("all {} methods stay {}", names.size(), reach);
  if (names.size() == 1)
    return fmt::format("{} bears the greatest {} of {} methods and stays {}", names.front(), what,
                       reaches.size(), reach);
  return fmt::format("{} of {} methods stay {}: {}", names.size(), reaches.size(), reach, some_of(names));
}

std::string failures_in_words(std::vector<MethodReach> reaches) {
  const auto count = std::ssize(reaches);
  std::erase_if(reaches, [](const MethodReach& reach) { return reach.fails < 0; });
  if (reaches.empty())
    return fmt::format("{} at no step that was tried.", count == 1 ? "It fails" : "They fail");
  std::stable_sort(reaches.begin(), reaches.end(),
                   [](const MethodReach& a, const MethodReach& b) { return a.fails < b.fails; });
  std::vector<std::string> names;
  for (const MethodReach& reach : reaches)
    names.push_back(fmt::format("{} at {} s ({})", label_in_sentence(reach.map->label),
                                setting_text(reach.fails), word(reach.then)));
  if (count == 1)
    return fmt::format("It fails at {} s ({}).", setting_text(reaches.front().fails),
                       word(reaches.front().then));
  return fmt::format("{} of {} methods {} within the steps tried, {}{}.", reaches.size(), count,
                     reaches.size() == 1 ? "fails" : "fail", reaches.size() == 1 ? "" : "the first ",
                     some_of(names));
}

std::string limits_in_words(const Stability& study) {
  double greatest = 0;
  long found = 0;
  for (const CriticalStep& step : study.critical_steps) {
    const double off = deviation(step);
    if (std::isnan(off)) continue;
    ++found;
    if (std::abs(off) > std::abs(greatest)) greatest = off;
  }
  if (found == 0) return "";
  return fmt::format(" The {} found {} within {:.2g} % of the {} predicted.",
                     found == 1 ? "critical step" : fmt::format("{} critical steps", found),
                     found == 1 ? "is" : "are", 100 * std::abs(greatest), found == 1 ? "one" : "ones");
}

}  // namespace

ToldPlace own_place(const Stability& study) {
  const ToldPlace of_axes[] = {{MapAxis::parameter, study.parameter_value},
                               {MapAxis::elements, static_cast<double>(study.elements)},
                               {MapAxis::duration, study.end}};
  for (const ToldPlace& place : of_axes) {
    if (place.axis == MapAxis::parameter && study.parameter.empty()) continue;
    for (const OutcomeMap& map : study.maps)
      if (has_place(map, place)) return place;
  }
  for (const OutcomeMap& map : study.maps)
    if (!map.values.empty()) return {map.axis, map.values.front()};
  return {};
}

std::vector<MethodReach> reaches_at(const Stability& study, ToldPlace place, bool by_step) {
  std::vector<MethodReach> reaches;
  for (const OutcomeMap& map : study.maps)
    if (map.by_step == by_step && has_place(map, place) && !map.settings.empty())
      reaches.push_back(reach_of(map, place.value));
  std::stable_sort(reaches.begin(), reaches.end(), [](const MethodReach& a, const MethodReach& b) {
    return a.accurate != b.accurate ? a.accurate > b.accurate : a.stable > b.stable;
  });
  return reaches;
}

StabilityConclusion conclude(const Stability& study) {
  const ToldPlace place = own_place(study);
  const std::vector<MethodReach> steps = reaches_at(study, place, true),
                                 tolerances = reaches_at(study, place, false);
  if (steps.empty() && tolerances.empty())
    return {"No run was made, so nothing can be said of any method.", ""};
  const std::string where =
      fmt::format("At {}, {}", value_text(study, place.axis, place.value), place_in_words(study, place.axis));
  StabilityConclusion conclusion;
  conclusion.sentence = fmt::format("{}: {}.", where,
                                    steps.empty() ? best_in_words(tolerances, false, study.tolerance)
                                                  : best_in_words(steps, true, study.tolerance));
  if (steps.empty()) return conclusion;
  conclusion.details = failures_in_words(steps) + limits_in_words(study);
  if (!tolerances.empty())
    conclusion.details += fmt::format(" Of those that choose their steps, {}.",
                                      best_in_words(tolerances, false, study.tolerance));
  return conclusion;
}

nlohmann::ordered_json stability_conclusion_json(const Stability& study) {
  using Json = nlohmann::ordered_json;
  const ToldPlace place = own_place(study);
  const StabilityConclusion conclusion = conclude(study);
  Json json{{"in_words", conclusion.sentence + (conclusion.details.empty() ? "" : " ") + conclusion.details},
            {"axis", word(place.axis)},
            {"value", place.value},
            {"methods", Json::array()}};
  for (const bool by_step : {true, false})
    for (const MethodReach& reach : reaches_at(study, place, by_step))
      json["methods"].push_back({{"label", reach.map->label},
                                 {"by_step", by_step},
                                 {"accurate_up_to", reach.accurate},
                                 {"stable_up_to", reach.stable},
                                 {"fails_at", reach.fails},
                                 {"then", word(reach.then)}});
  return json;
}

}  // namespace plumb
