#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/integrate/state.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

using Vec3 = Eigen::Vector3d;

/// A place on the cable's centre line.
struct CurvePoint {
  Vec3 position;     ///< m
  Vec3 tangent;      ///< unit vector, towards the last end
  double place = 0;  ///< counts elements from the first end, in [0, elements]
};

/// A finished run as a motion: states at any time and the cable's shape in them.
class Motion {
 public:
  /// `trajectory` must outlive it; what it holds is shown `offset` (m) away. Throws OutputError when it has
  /// no outputs, or one that cannot be drawn: not finite, of the wrong size, or a million cable lengths away.
  explicit Motion(const Trajectory& trajectory, const Vec3& offset = Vec3::Zero());

  /// Time of the last output, s.
  double end() const { return trajectory_.times.back(); }
  int elements() const { return trajectory_.elements; }

  /// Nodal coordinates and their rates at a time, s, kept inside the outputs'; cubic in time between two
  /// outputs. The offset is in neither.
  State at(double time) const;
  Eigen::VectorXd state(double time) const { return at(time).q; }
  /// Nodal coordinates of output i.
  const Eigen::VectorXd& output(std::size_t i) const { return trajectory_.q[i]; }
  double output_time(std::size_t i) const { return trajectory_.times[i]; }
  std::size_t output_count() const { return trajectory_.times.size(); }

  /// The cable at a place that counts elements from the first end, in [0, elements()].
  CurvePoint point(const Eigen::VectorXd& state, double place) const;
  /// Its last end, m.
  Vec3 tip(const Eigen::VectorXd& state) const {
    return state.segment<3>(6 * trajectory_.elements) + offset_;
  }
  /// The mean of places evenly along it, m.
  Vec3 middle(const Eigen::VectorXd& state) const;

 private:
  const Trajectory& trajectory_;
  Vec3 offset_;
};

/// Places along the cable over the whole motion, m, enough of them to tell the space that it fills. The first
/// is the first end at the start.
std::vector<Vec3> covered_places(const Motion& motion);

}  // namespace plumb
