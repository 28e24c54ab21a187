#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/case/case.h"
#include "engine/kernels/kernels.h"
#include "engine/model/block_lu.h"
#include "engine/model/integration_points.h"
#include "engine/model/own_units.h"

namespace plumb {

/// The damping of a cable: −α M v with α in 1/s, and Kelvin and Voigt's with τ in s, which adds EA τ ε̇ to the
/// force of stretching and EI τ κ̇ to the moment of bending.
///
/// With k = r' × r''/|r'|ᵐ (m = 3 geometric, 2 material) and κ = |k|, κ̇ δκ = δk · P k̇ with P = k kᵀ/κ².
/// Where the cable is straight κ has no derivative; there P is the identity, as P of a cable that bends in a
/// plane is across its direction. Between the two lies P = (k kᵀ + s² I)/(κ² + s²) with an s that is
/// round-off: no rotation of a bent cable is damped.
class Damping {
 public:
  Damping(const DampingSpec& spec, const ElementConstants& element, int elements);

  /// The same in those units, in which `element` is already.
  Damping in_units(const OwnUnits& units, const ElementConstants& element) const;

  bool none() const { return by_mass_ == 0 && !of_material(); }
  double by_mass() const { return by_mass_; }  ///< α, 1/s
  bool of_material() const { return axial_ != 0 || bending_ != 0; }

  /// f := f + the forces of the material. Where a slope has collapsed nothing is added.
  void add_force(const Eigen::VectorXd& q, const Eigen::VectorXd& v, Eigen::VectorXd& f) const;
  /// A := A − stiffness_factor ∂f/∂q − rate_factor ∂f/∂v of these.
  void add_system(const Eigen::VectorXd& q, const Eigen::VectorXd& v, double stiffness_factor,
                  double rate_factor, GeneralBlockTridiagonal<double>& A) const;

 private:
  DampingSpec spec_;
  int elements_;
  double by_mass_, axial_, bending_;  // 1/s, N s, N m² s
  bool green_;
  double straight_;  // s, 1/m
  std::vector<IntegrationPoint> axial_points_, bending_points_;
};

}  // namespace plumb
