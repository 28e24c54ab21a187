#pragma once

#include <Eigen/Core>

namespace plumb {

/// Units of a case's own, in which its length, mass and duration are from 1 to 2. They are powers of two, so
/// that numbers lose nothing on the way there and back, and the same case in other units is computed bit for
/// bit alike.
struct OwnUnits {
  double length = 1;  ///< m
  double time = 1;    ///< s
  double mass = 1;    ///< kg

  /// Of three numbers > 0.
  static OwnUnits of(double length, double time, double mass);

  double force() const { return mass * length / (time * time); }  ///< N
  double moment() const { return force() * length; }              ///< N m
};

/// Multiplies the first three of each six numbers by one factor and the others by another: what nodal
/// coordinates (m and 1), rates or forces are in other units.
void scale_nodal(double positions, double slopes, Eigen::VectorXd& nodal);

}  // namespace plumb
