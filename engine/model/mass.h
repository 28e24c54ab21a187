#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "engine/kernels/kernels.h"
#include "engine/model/block_tridiagonal.h"
#include "engine/model/element_place.h"
#include "engine/model/own_units.h"
#include "engine/model/supports.h"

namespace plumb {

/// A mass on an element: m sᵢsⱼ with the shape functions of its place.
struct PointMass {
  int element;
  std::array<double, 4> shape;  ///< 1 and m
  double mass;                  ///< kg
};

/// The masses of a case. Those of a chain are shared out between the ends of their links, as its own are.
std::vector<PointMass> point_masses(const Case& spec);

/// The same masses in those units.
std::vector<PointMass> in_units(std::vector<PointMass> points, const OwnUnits& units);

/// The constant, consistent mass matrix ∫ ρA sᵢsⱼ dx of a mesh of equal elements, with masses on it. It is m
/// ⊗ I₃ with a scalar band matrix m of half bandwidth 3 over (r₀, r'₀, r₁, r'₁, …); it is factored once, with
/// the supports applied.
class MassMatrix {
 public:
  /// ρA and l of `element` must be > 0.
  MassMatrix(const ElementConstants& element, int elements, const SupportProjection& supports,
             std::vector<PointMass> points = {});

  const std::vector<PointMass>& points() const { return points_; }
  /// A := A + factor times the masses that are points.
  void add_points(double factor, BlockTridiagonal& A) const;
  /// ½ vᵀ M v of these alone, J.
  double kinetic_energy_of_points(const Eigen::VectorXd& v) const;

  /// y := M v, without supports. y gets the size of v.
  void multiply(const Eigen::VectorXd& v, Eigen::VectorXd& y) const;

  /// x := the acceleration that the force x gives the supported cable: P M P a = P x with a = P a. `scratch`
  /// is only used where a direction is held, and is then given the size of x.
  void solve(Eigen::VectorXd& x, Eigen::VectorXd& scratch) const;

  /// The factors with which alone `solve` works, valid as long as this matrix or a copy of it; nullptr where
  /// a direction is held, which takes two.
  const MassFactors* factors() const { return along_ ? nullptr : &across_->view; }

  /// ½ vᵀ M v, J.
  double kinetic_energy(const Eigen::VectorXd& v) const;

 private:
  /// Lists of factors from both ends, cut where they have settled, and the kernels' view of them.
  struct Factors {
    std::vector<MassFactor> from_left, from_right;
    MassFactor middle;
    MassFactors view;
  };

  /// `slopes_held`: what is held in direction holds its slope.
  std::shared_ptr<const Factors> factor(bool slopes_held) const;

  ElementConstants element_;
  int elements_;
  SupportProjection supports_;
  std::vector<PointMass> points_;
  std::shared_ptr<const Factors> across_;  // for motion across the held direction
  std::shared_ptr<const Factors> along_;   // for motion along it; only with a direction held
};

}  // namespace plumb
