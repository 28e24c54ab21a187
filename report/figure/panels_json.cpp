#include "report/figure/panels_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/figure/curve_style.h"
#include "report/figure/number_markup.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json extent_json(const Extent& extent) {
  return {{"lower", extent.lower}, {"upper", extent.upper}};
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
  Json json{{"label", plain_text(axis.label)},
            {"scale", axis.scale == Scale::logarithmic ? "logarithmic" : "linear"},
            {"zero_line", axis.zero_line}};
  if (axis.range) json["range"] = *axis.range;
  if (!axis.column.empty()) json["column"] = axis.column;
  return json;
}

Json series_json(const Series& series) {
  Json json{{"label", plain_text(series.label)},
            {"line", series.line_width > 0},
            {"dash", word(series.dash)},
            {"marker", series.marker != Marker::none}};
  if (series.color) json["color"] = css(*series.color);
  json["x"] = series.x;
  json["y"] = series.y;
  if (!series.band.lower.empty()) json["band"] = extent_json(series.band);
  if (!series.x_error.lower.empty()) json["x_error"] = extent_json(series.x_error);
  if (!series.y_error.lower.empty()) json["y_error"] = extent_json(series.y_error);
  return json;
}

Json rule_json(const Rule& rule) {
  return {{"upright", rule.upright}, {"from", rule.from}, {"to", rule.to}, {"label", plain_text(rule.label)}};
}

}  // namespace

Json panels_json(const Plot& plot, const std::vector<PanelTimes>& times) {
  Json panels = Json::array();
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const Panel& panel = plot.panels[p];
    Json json{{"title", plain_text(panel.title)},
              {"x", axis_json(panel.x)},
              {"y", axis_json(panel.y)},
              {"over_time", p < times.size() && times[p].along_x},
              {"equal_axes", panel.equal_axes},
              {"height_share", panel.height_share},
              {"shares_x_below", panel.shares_x_below},
              {"only_series", !panel.cells && !panel.heat_map && panel.bars.empty()},
              {"series", Json::array()},
              {"rules", Json::array()}};
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
      json["series"].push_back(series_json(panel.series[s]));
      if (p < times.size() && s < times[p].of_points.size())
        json["series"].back()["time"] = times[p].of_points[s];
    }
    if (panel.heat_map)
      json["heat_map"] = {{"x_edges", panel.heat_map->x_edges},
                          {"y_edges", panel.heat_map->y_edges},
                          {"values", panel.heat_map->values}};
    for (const Rule& rule : panel.rules) json["rules"].push_back(rule_json(rule));
    panels.push_back(std::move(json));
  }
  return panels;
}

}  // namespace plumb
