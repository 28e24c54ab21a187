#include "engine/run/mode_table.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/case/probe_columns.h"
#include "engine/run/probes.h"

namespace plumb {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// (f(+) − f(−))/2h, and where both sides are alike, as of the curvature of a straight cable, (f(+) −
/// f(0))/h.
double change_of(double before, double rest, double after, double h) {
  const double even = after + before - 2 * rest, odd = after - before;
  return std::abs(even) > std::abs(odd) ? (after - rest) / h : odd / (2 * h);
}

}  // namespace

Eigen::VectorXd displaced(const VibrationMode& mode, double reach, double phase) {
  const double greatest = greatest_displacement(mode), scale = greatest > 0 ? reach / greatest : 0;
  Eigen::VectorXd result = scale * std::cos(turn * phase) * mode.shape;
  if (mode.quadrature.size() > 0) result -= scale * std::sin(turn * phase) * mode.quadrature;
  return result;
}

ProbeTable mode_table(const Case& spec, const Trajectory& trajectory) {
  constexpr double small = 1e-6;  // of the length
  ProbeTable table;
  const std::vector<VibrationMode>& modes = trajectory.vibrations.modes;
  if (modes.empty()) return table;
  for (const ModeColumn& column : mode_columns())
    table.columns.push_back({std::string(column.name), std::string(column.unit), {}});
  const std::size_t own = table.columns.size(), first = 0;
  // The rest and both sides of each mode as one motion, so that the probes are read as of any.
  Trajectory sides;
  sides.elements = trajectory.elements;
  const double h = small * spec.cable.length;
  const auto add = [&](const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    sides.times.push_back(static_cast<double>(sides.times.size()));
    sides.q.push_back(q);
    sides.v.push_back(v);
  };
  const Eigen::VectorXd& rest = trajectory.q.front();
  add(rest, Eigen::VectorXd::Zero(rest.size()));
  for (const VibrationMode& mode : modes) {
    const Eigen::VectorXd shape = displaced(mode, 1, 0);
    add(rest + h * shape, turn * mode.frequency * h * shape);
    add(rest - h * shape, Eigen::VectorXd::Zero(rest.size()));
    // Positions and slopes are taken as they are.
    add(shape, shape);
  }
  const ProbeTable seen = probe(spec, sides);
  for (const Column& column : seen.columns) table.columns.push_back({column.name, column.unit, {}});
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const VibrationMode& mode = modes[k];
    table.times.push_back(static_cast<double>(k + 1));
    const std::array<double, 4> values{mode.frequency, turn * mode.frequency, mode.damping_ratio, mode.decay};
    for (std::size_t c = 0; c < own; ++c) table.columns[c].values.push_back(values[c]);
    std::size_t c = own;
    const std::size_t after = 1 + 3 * k;
    for (const ProbeSpec& spec_of : spec.probes)
      for (std::size_t part = 0; part < column_names(spec_of).size(); ++part, ++c) {
        const std::vector<double>& at = seen.columns[c - own].values;
        const bool linear = spec_of.quantity == Quantity::position ||
                            spec_of.quantity == Quantity::relative_position ||
                            spec_of.quantity == Quantity::slope;
        table.columns[c].values.push_back(linear ? at[after + 2]
                                          : spec_of.quantity == Quantity::velocity
                                              ? at[after] / h
                                              : change_of(at[after + 1], at[first], at[after], h));
      }
  }
  return table;
}

std::string modes_csv(const Trajectory& trajectory, const ProbeTable& modes) {
  std::string text = "mode,kind";
  for (const Column& column : modes.columns) text += fmt::format(",{} [{}]", column.name, column.unit);
  text += '\n';
  for (std::size_t k = 0; k < modes.times.size(); ++k) {
    text += fmt::format("{},{}", k + 1, word(trajectory.vibrations.modes[k].kind));
    for (const Column& column : modes.columns) text += fmt::format(",{:.17g}", column.values[k]);
    text += '\n';
  }
  return text;
}

}  // namespace plumb
