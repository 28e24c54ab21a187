#pragma once

#include "engine/case/case.h"
#include "engine/kernels/kernels.h"

namespace plumb {

/// The elastic part of the gradient-deficient ANCF cable element: two nodes with position and slope, no
/// shear, no torsion (Gerstmayr and Shabana 2006; Recuero and Negrut 2016). The strain energy is ∫ ½EA ε² +
/// ½EI κ² dx.
///
/// The curvature enters as κ² = |r' × r''|² / (r'·r')^p with p = 3 (geometric) or 2 (material), which is
/// smooth for a straight cable where κ itself is not. Forces and energies of whole chains are those of the
/// kernels.
class Element {
 public:
  /// EA in N and EI in N m², both ≥ 0; element length l in m, > 0.
  Element(double axial_stiffness, double bending_stiffness, double length, StrainModel strain);

  /// Strain ε of a slope vector r'.
  double strain(const Vec3& slope) const;
  /// Curvature κ (1/m) from r' and r'' (1/m); of a collapsed slope, that at the floor.
  double curvature(const Vec3& slope, const Vec3& slope_rate) const;
  /// Part along the cable of the force in it (N), tension > 0: n·t with n = ∂W/∂r' - (∂W/∂r'')', W being the
  /// energy a metre. With λ = |r'| it is EA ε λ - EI κ²/λ (geometric) or EA ε (material).
  double axial_force(const Vec3& slope, const Vec3& slope_rate) const;
  /// Bending moment (N m), |r' × ∂W/∂r''|: EI κ/λ (geometric) or EI κ (material).
  double bending_moment(const Vec3& slope, const Vec3& slope_rate) const;

  double axial_stiffness() const { return axial_stiffness_; }
  double bending_stiffness() const { return bending_stiffness_; }
  double length() const { return length_; }
  StrainModel strain_model() const { return strain_; }

 private:
  double axial_stiffness_;
  double bending_stiffness_;
  double length_;
  StrainModel strain_;
};

}  // namespace plumb
