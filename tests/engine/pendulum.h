#pragma once

#include <cmath>
#include <numbers>

#include "engine/integrate/integrate.h"

namespace plumb {

/// The pendulum of Recuero and Negrut (2016) as stated there: f softens it axially; rigid start, g = 9.81
/// m/s².
inline Case pendulum(double f, int elements) {
  Case spec;
  spec.title = "pendulum";
  spec.cable.length = 1;
  spec.cable.area = 1e-6 * f * f;
  spec.cable.density = 8000 / (f * f);
  spec.cable.youngs_modulus = 1e9 / (f * f * f * f);
  spec.cable.second_moment = spec.cable.area * spec.cable.area / (4 * std::numbers::pi);
  spec.cable.elements = elements;
  spec.start.angular_velocity = {0, 4, 0};
  spec.supports.first = Support::pinned;
  spec.loads.gravity = {0, -9.81, 0};
  spec.time = {2, 0.02};
  return spec;
}

/// A method with all its parameters at their defaults.
inline MethodSpec method(const std::string& name, std::optional<double> step,
                         std::optional<double> tolerance = {}) {
  MethodSpec spec{name, step, tolerance, tolerance, {}};
  for (const MethodParameter& parameter : find_method(name)->parameters)
    spec.parameters[parameter.name] = parameter.fallback;
  return spec;
}

inline Trajectory run(Case spec, const MethodSpec& with, const TimeSpec& time) {
  spec.method = with;
  spec.time = time;
  return integrate(spec);
}

/// Position of the tip at an output.
inline Vec3 tip(const Trajectory& trajectory, std::size_t output) {
  return trajectory.q[output].tail<6>().head<3>();
}
inline Vec3 tip(const Trajectory& trajectory) {
  return tip(trajectory, trajectory.q.size() - 1);
}

/// Greatest distance between the tips of two trajectories over common outputs.
inline double tip_distance(const Trajectory& a, const Trajectory& b) {
  double worst = a.times == b.times ? 0 : 1e300;
  for (std::size_t k = 0; k < std::min(a.q.size(), b.q.size()); ++k)
    worst = std::max(worst, (tip(a, k) - tip(b, k)).norm());
  return worst;
}

}  // namespace plumb
