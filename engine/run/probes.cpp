#include "engine/run/probes.h"

#include <fmt/format.h>

#include "engine/integrate/state_at.h"
#include "engine/model/cable.h"
#include "engine/run/cable_field.h"

namespace plumb {
namespace {

/// The values of one probe at one state, as many as it has columns.
void read(const Cable& cable, const ProbeSpec& spec, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
          double values[3]) {
  const auto vector = [&](const Vec3& x) {
    for (int k = 0; k < 3; ++k) values[k] = x[k];
  };
  const auto scalar = [&](ColorField field) { values[0] = field_value(cable, field, q, v, spec.at); };
  switch (spec.quantity) {
    case Quantity::position:
      return vector(cable.at(q, spec.at).position);
    case Quantity::velocity:
      return vector(cable.interpolate(v, spec.at));
    case Quantity::slope:
      return vector(cable.at(q, spec.at).slope);
    case Quantity::axial_strain:
      return scalar(ColorField::axial_strain);
    case Quantity::axial_force:
      return scalar(ColorField::axial_force);
    case Quantity::curvature:
      return scalar(ColorField::curvature);
    case Quantity::bending_moment:
      return scalar(ColorField::bending_moment);
  }
}

ProbeTable empty_table(const Case& spec) {
  ProbeTable table;
  for (const ProbeSpec& p : spec.probes)
    for (const std::string& name : column_names(p))
      table.columns.push_back({name, std::string(unit(p.quantity)), {}});
  return table;
}

void add_row(const Case& spec, const Cable& cable, double t, const Eigen::VectorXd& q,
             const Eigen::VectorXd& v, ProbeTable& table) {
  table.times.push_back(t);
  std::size_t column = 0;
  for (const ProbeSpec& p : spec.probes) {
    double values[3];
    read(cable, p, q, v, values);
    const std::size_t count = is_vector(p.quantity) ? 3 : 1;
    for (std::size_t k = 0; k < count; ++k) table.columns[column++].values.push_back(values[k]);
  }
}

}  // namespace

ProbeTable probe(const Case& spec, const Trajectory& trajectory) {
  const Cable cable(spec);
  ProbeTable table = empty_table(spec);
  for (std::size_t k = 0; k < trajectory.times.size(); ++k)
    add_row(spec, cable, trajectory.times[k], trajectory.q[k], trajectory.v[k], table);
  return table;
}

ProbeTable probe(const Case& spec, const Trajectory& trajectory, const std::vector<double>& times) {
  const Cable cable(spec);
  ProbeTable table = empty_table(spec);
  for (const double t : times) {
    const State state = state_at(trajectory, t);
    add_row(spec, cable, t, state.q, state.v, table);
  }
  return table;
}

ProbeTable probe_without(const Case& spec, const Trajectory& trajectory,
                         const std::vector<std::size_t>& outputs) {
  const Cable cable(spec);
  ProbeTable table = empty_table(spec);
  const auto output = [&](std::size_t k) {
    return State{trajectory.times[k], trajectory.q[k], trajectory.v[k]};
  };
  State state;
  for (const std::size_t k : outputs) {
    hermite_in_time(output(k - 1), output(k + 1), trajectory.times[k], state);
    add_row(spec, cable, state.t, state.q, state.v, table);
  }
  return table;
}

std::string to_csv(const ProbeTable& table) {
  std::string text = "t [s]";
  for (const Column& column : table.columns) text += fmt::format(",{} [{}]", column.name, column.unit);
  text += '\n';
  for (std::size_t k = 0; k < table.times.size(); ++k) {
    text += fmt::format("{:.17g}", table.times[k]);
    for (const Column& column : table.columns) text += fmt::format(",{:.17g}", column.values[k]);
    text += '\n';
  }
  return text;
}

}  // namespace plumb
