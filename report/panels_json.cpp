#include "report/panels_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string hex(const Color& color) {
  const auto byte = [](float part) { return static_cast<int>(std::lround(255 * part)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
}

std::string_view word(Dash dash) {
  switch (dash) {
    case Dash::solid:
      return "solid";
    case Dash::dashed:
      return "dashed";
    case Dash::dotted:
      return "dotted";
  }
  return "solid";
}

Json axis_json(const Axis& axis) {
  Json json{{"label", axis.label},
            {"scale", axis.scale == Scale::logarithmic ? "logarithmic" : "linear"},
            {"zero_line", axis.zero_line}};
  if (axis.range) json["range"] = *axis.range;
  return json;
}

Json series_json(const Series& series) {
  Json json{{"label", series.label},
            {"line", series.line_width > 0},
            {"dash", word(series.dash)},
            {"marker", series.marker != Marker::none}};
  if (series.color) json["color"] = hex(*series.color);
  json["x"] = series.x;
  json["y"] = series.y;
  return json;
}

Json rule_json(const Rule& rule) {
  return {{"upright", rule.upright}, {"from", rule.from}, {"to", rule.to}, {"label", rule.label}};
}

}  // namespace

Json panels_json(const Plot& plot, const std::vector<PanelTimes>& times) {
  Json panels = Json::array();
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const Panel& panel = plot.panels[p];
    Json json{{"title", panel.title},
              {"x", axis_json(panel.x)},
              {"y", axis_json(panel.y)},
              {"over_time", p < times.size() && times[p].along_x},
              {"equal_axes", panel.equal_axes},
              {"height_share", panel.height_share},
              {"shares_x_below", panel.shares_x_below},
              {"only_series", !panel.cells && panel.bars.empty()},
              {"series", Json::array()},
              {"rules", Json::array()}};
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
      json["series"].push_back(series_json(panel.series[s]));
      if (p < times.size() && s < times[p].of_points.size())
        json["series"].back()["time"] = times[p].of_points[s];
    }
    for (const Rule& rule : panel.rules) json["rules"].push_back(rule_json(rule));
    panels.push_back(std::move(json));
  }
  return panels;
}

}  // namespace plumb
