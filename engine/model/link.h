#pragma once

#include <Eigen/Core>

#include "engine/case/case.h"

namespace plumb {

/// A straight link of a chain, which stretches only, with the strain energy ½ EA l ε². Its state is the
/// vector d from its first end to its second, m, and λ = |d|/l:
///   green-geometric: ε = ½(λ² − 1);   engineering-material: ε = λ − 1.
class Link {
 public:
  /// EA in N, ≥ 0; undeformed length l in m, > 0.
  Link(double axial_stiffness, double length, StrainModel strain);

  /// False where λ ≤ slope_floor or d is not a number. What follows may be asked of whole links only.
  bool is_whole(const Vec3& d) const;

  double energy(const Vec3& d) const;  ///< U, J
  Vec3 gradient(const Vec3& d) const;  ///< ∂U/∂d, N: the force that the link pulls its first end with
  Eigen::Matrix3d tangent(const Vec3& d) const;  ///< ∂²U/∂d², N/m

  /// A discrete gradient D(d₀, d₁) (Gonzalez 1996): D · (d₁ − d₀) = U(d₁) − U(d₀) exactly, along the mean of
  /// d.
  Vec3 discrete_gradient(const Vec3& d0, const Vec3& d1) const;
  /// ∂D/∂d₁, which is not symmetric, N/m.
  Eigen::Matrix3d discrete_tangent(const Vec3& d0, const Vec3& d1) const;

 private:
  double strain(const Vec3& d) const;

  double stiffness_;
  double length_;
  bool green_;
};

}  // namespace plumb
