#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/integrate/trajectory.h"

namespace plumb {

using Vec3 = Eigen::Vector3d;

/// A place on the cable's centre line.
struct CurvePoint {
  Vec3 position;  ///< m
  Vec3 tangent;   ///< unit vector, towards the last end
};

/// A finished run as a motion: states at any time and the cable's shape in them.
class Motion {
 public:
  /// `trajectory` must outlive it. Throws OutputError when it has no outputs, or one that cannot be drawn:
  /// not finite, of the wrong size, or a million cable lengths away.
  explicit Motion(const Trajectory& trajectory);

  /// Time of the last output, s.
  double end() const { return trajectory_.times.back(); }
  int elements() const { return trajectory_.elements; }

  /// Nodal coordinates at a time, s, kept inside the outputs'; cubic in time between two outputs.
  Eigen::VectorXd state(double time) const;
  /// Nodal coordinates of output i.
  const Eigen::VectorXd& output(std::size_t i) const { return trajectory_.q[i]; }
  std::size_t output_count() const { return trajectory_.times.size(); }

  /// The cable in a state: `per_element` ≥ 1 pieces an element, each on the element's own cubic curve.
  std::vector<CurvePoint> curve(const Eigen::VectorXd& state, int per_element) const;
  /// The cable at a place that counts elements from the first end, in [0, elements()].
  CurvePoint point(const Eigen::VectorXd& state, double place) const;
  /// Its last end, m.
  Vec3 tip(const Eigen::VectorXd& state) const { return state.segment<3>(6 * trajectory_.elements); }

 private:
  const Trajectory& trajectory_;
};

}  // namespace plumb
