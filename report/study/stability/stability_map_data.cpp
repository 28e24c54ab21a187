#include "report/study/stability/stability_map_data.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/study/stability/step_in_words.h"
#include "render/plot/cell_grid.h"
#include "report/figure/curve_style.h"
#include "report/figure/outcome_style.h"
#include "report/study/stability/stability_results.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

/// To four digits, which is more than is shown.
Json shown(double value, bool known = true) {
  if (!known || !std::isfinite(value)) return nullptr;
  if (value == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 3);
  return std::isfinite(1 / unit) ? std::round(value / unit) * unit : value;
}

Json point_json(const StabilityPoint& point) {
  Json json{{"o", outcome_place(point.outcome)},
            {"e", shown(point.error, point.error >= 0)},
            {"j", shown(point.judged_until, point.judged_until >= 0)},
            {"t", shown(point.end_time, point.end_time >= 0)},
            {"d", shown(point.energy_change)}};
  if (!point.message.empty()) json["m"] = point.message;
  return json;
}

Json map_json(const Stability& study, const OutcomeMap& map) {
  Json json{{"label", map.label},
            {"axis", word(map.axis)},
            {"by_step", map.by_step},
            {"settings", map.settings},
            {"values", map.values},
            {"words", map.in_words},
            {"where", place_in_words(study, map.axis)},
            {"limits", Json::array()},
            {"points", Json::array()}};
  for (const double setting : map.settings) json["setting_labels"].push_back(setting_text(setting));
  for (const double value : map.values) {
    json["value_names"].push_back(value_text(study, map.axis, value));
    json["value_labels"].push_back(map.axis == MapAxis::elements ? std::to_string(std::lround(value))
                                                                 : value_text(study, map.axis, value));
  }
  for (const PredictedLimit& limit : map.limits)
    json["limits"].push_back({shown(limit.at_start), shown(limit.at_worst)});
  for (const StabilityPoint& point : map.points) json["points"].push_back(point_json(point));
  return json;
}

}  // namespace

std::string stability_map_data(const Stability& study) {
  Json json{
      {"axis_names", {{"parameter", study.parameter}, {"elements", "elements"}, {"duration", "duration"}}},
      {"outcomes", Json::array()},
      {"maps", Json::array()}};
  for (const OutcomeStyle& style : outcome_styles())
    json["outcomes"].push_back({{"name", word(style.outcome)},
                                {"letter", style.letter},
                                {"color", css(style.color)},
                                {"ink", css(ink_on(style.color))},
                                {"meaning", style.meaning}});
  for (const OutcomeMap& map : study.maps) json["maps"].push_back(map_json(study, map));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace plumb
