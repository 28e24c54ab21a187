#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/cable.h"
#include "engine/run/cable_field.h"
#include "engine/run/field_envelope.h"
#include "engine/run/field_map.h"
#include "report/figure/ending_mark.h"
#include "report/figure/number_markup.h"
#include "report/figure/round_off.h"
#include "report/figure/run_figures.h"

namespace plumb {
namespace {

// As fine as a picture shows, and few enough numbers for a file.
constexpr int map_columns = 300, map_rows = 120;

constexpr const char* place_label = "distance along the cable [m]";

/// The cable that was computed.
Cable cable_of(const Run& run) {
  Case spec = run.loaded.spec;
  spec.cable.elements = run.trajectory.elements;
  return Cable(spec);
}

std::string axis_label(std::string_view name, ColorField field) {
  return fmt::format("{} [{}]", name, unit_markup(unit(field)));
}

Series along(const FieldEnvelope& envelope, std::vector<double> values, std::string label) {
  Series series;
  series.label = std::move(label);
  series.x = envelope.places;
  series.y = std::move(values);
  series.color = palette[0];
  return series;
}

/// What rounding makes of the curvature of a straight cable, 1/m: places of the size of its length are
/// rounded by some units in the last place, and the second derivative of the shape functions has 6/l² before
/// them.
double curvature_round_off(const Cable& cable, int elements) {
  constexpr double units = 8;
  const double element = cable.length() / elements;
  return units * std::numeric_limits<double>::epsilon() * cable.length() * 6 / (element * element);
}

std::optional<Figure> range_figure(const Run& run, ColorField field, const std::string& quantity,
                                   const std::string& label) {
  if (run.trajectory.times.empty()) return {};
  const Cable cable = cable_of(run);
  const FieldEnvelope envelope = field_envelope(cable, field, run.trajectory);
  if (!std::isfinite(envelope.peak)) return {};
  Series greatest = along(envelope, envelope.greatest, "maximum");
  Series least = along(envelope, envelope.least, "minimum");
  Series mean = along(envelope, envelope.mean, "mean over time");
  mean.band = {envelope.least, envelope.greatest};
  greatest.line_width = least.line_width = 0.6;
  greatest.dash = Dash::dashed;
  least.dash = Dash::dotted;

  Panel panel;
  panel.x.label = place_label;
  panel.x.range = {0, cable.length()};
  panel.y.label = axis_label(label, field);
  panel.y.zero_line = true;
  panel.series = {std::move(greatest), std::move(mean), std::move(least)};
  if (field == ColorField::curvature)
    mark_round_off(panel, curvature_round_off(cable, run.trajectory.elements));
  Figure figure;
  figure.title = title_of(run, fmt::format("Range of the {} over time", quantity));
  const auto lowest = std::min_element(envelope.least.begin(), envelope.least.end(), [](double a, double b) {
    return a < b || (std::isnan(b) && !std::isnan(a));
  });
  figure.alt = fmt::format(
      "Plot of the minimum, mean and maximum over time of the {} along the cable. The greatest is {:.4g} {}, "
      "{:.4g} m from the first end, at {:.4g} s; the least is {:.4g} {}.",
      quantity, envelope.peak, unit(field), envelope.peak_place, envelope.peak_time, *lowest, unit(field));
  figure.plot.panels = {std::move(panel)};
  return figure;
}

}  // namespace

std::optional<Figure> tension_range_figure(const Run& run) {
  return range_figure(run, ColorField::axial_force, "tension", "tension");
}

std::optional<Figure> curvature_range_figure(const Run& run) {
  // Links of a chain do not bend.
  if (run.loaded.spec.cable.model == CableModel::chain) return {};
  return range_figure(run, ColorField::curvature, "curvature", "curvature κ");
}

std::optional<Figure> strain_map_figure(const Run& run) {
  if (run.trajectory.times.empty()) return {};
  const Cable cable = cable_of(run);
  const FieldMap found = field_map(cable, ColorField::axial_strain, run.trajectory, map_columns, map_rows);
  double lo = HUGE_VAL, hi = -HUGE_VAL;
  for (const double value : found.values)
    if (std::isfinite(value)) {
      lo = std::min(lo, value);
      hi = std::max(hi, value);
    }
  if (!(lo <= hi)) return {};
  HeatMap map;
  map.x_edges = found.time_edges;
  map.y_edges = found.place_edges;
  map.values = found.values;
  map.label = axis_label("axial strain ε", ColorField::axial_strain);
  // Stretched and slack parts are told apart where there is enough of both.
  constexpr double enough = 0.05;
  map.diverging = lo < 0 && hi > 0 && std::min(-lo, hi) > enough * std::max(-lo, hi);

  Panel panel;
  panel.x.label = "time [s]";
  panel.y.label = place_label;
  panel.heat_map = std::move(map);
  mark_ending(run, panel);
  Figure figure;
  figure.title = title_of(run, "Axial strain over time and place");
  figure.alt = fmt::format(
      "Map of the axial strain over time, from left to right, and along the cable, from its first end at the "
      "bottom. The cells are from {:.4g} to {:.4g}.",
      lo, hi);
  figure.plot.height = 1000;
  figure.plot.panels = {std::move(panel)};
  return figure;
}

}  // namespace plumb
