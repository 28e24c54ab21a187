#include "engine/run/probes.h"

#include <fmt/format.h>

#include "engine/integrate/state_at.h"
#include "engine/model/cable.h"
#include "engine/model/support_motion.h"
#include "engine/run/cable_field.h"

namespace plumb {
namespace {

/// Reads the probes of a case off states, a row each.
class Prober {
 public:
  explicit Prober(const Case& spec) : spec_(spec), cable_(spec), supports_(spec) {
    for (const ProbeSpec& p : spec.probes)
      for (const std::string& name : column_names(p))
        table_.columns.push_back({name, std::string(unit(p.quantity)), {}});
  }

  void add_row(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    table_.times.push_back(t);
    std::size_t column = 0;
    for (const ProbeSpec& p : spec_.probes) {
      const Vec3 values = read(p, t, q, v);
      const Eigen::Index count = is_vector(p.quantity) ? 3 : 1;
      for (Eigen::Index k = 0; k < count; ++k) table_.columns[column++].values.push_back(values[k]);
    }
  }

  ProbeTable table() { return std::move(table_); }

 private:
  /// As many numbers as the probe has columns, and zeros.
  Vec3 read(const ProbeSpec& probe, double t, const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
    const auto scalar = [&](ColorField field) {
      return Vec3(field_value(cable_, field, q, v, probe.at), 0, 0);
    };
    switch (probe.quantity) {
      case Quantity::position:
        return cable_.at(q, probe.at).position;
      case Quantity::relative_position:
        return supports_.at(t).turn.transpose() * (cable_.at(q, probe.at).position - q.head<3>());
      case Quantity::velocity:
        return cable_.interpolate(v, probe.at);
      case Quantity::slope:
        return cable_.at(q, probe.at).slope;
      case Quantity::axial_strain:
        return scalar(ColorField::axial_strain);
      case Quantity::axial_force:
        return scalar(ColorField::axial_force);
      case Quantity::curvature:
        return scalar(ColorField::curvature);
      case Quantity::bending_moment:
        return scalar(ColorField::bending_moment);
    }
    return Vec3::Zero();
  }

  const Case& spec_;
  Cable cable_;
  SupportMotion supports_;
  ProbeTable table_;
};

}  // namespace

ProbeTable probe(const Case& spec, const Trajectory& trajectory) {
  Prober prober(spec);
  for (std::size_t k = 0; k < trajectory.times.size(); ++k)
    prober.add_row(trajectory.times[k], trajectory.q[k], trajectory.v[k]);
  return prober.table();
}

ProbeTable probe(const Case& spec, const Trajectory& trajectory, const std::vector<double>& times) {
  Prober prober(spec);
  for (const double t : times) {
    const State state = state_at(trajectory, t);
    prober.add_row(t, state.q, state.v);
  }
  return prober.table();
}

ProbeTable probe_without(const Case& spec, const Trajectory& trajectory,
                         const std::vector<std::size_t>& outputs) {
  Prober prober(spec);
  const auto output = [&](std::size_t k) {
    return State{trajectory.times[k], trajectory.q[k], trajectory.v[k]};
  };
  State state;
  for (const std::size_t k : outputs) {
    hermite_in_time(output(k - 1), output(k + 1), trajectory.times[k], state);
    prober.add_row(state.t, state.q, state.v);
  }
  return prober.table();
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
