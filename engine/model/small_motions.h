#pragma once

#include <complex>
#include <optional>

#include "engine/model/block_lu.h"
#include "engine/model/cable.h"
#include "engine/model/strain_stiffness.h"

namespace plumb {

/// Small motions x of a cable about a state in which it rests in a frame that turns steadily with it:
///   M ẍ + D ẋ + K x = 0
/// in what the supports leave free. With S = [Ω×] on positions and slopes alike, K = −∂f/∂q + M S² and D =
/// −∂f/∂v + 2 M S: the loss of stiffness by the spin, damping and Coriolis's forces; tension by the spin is
/// in ∂f/∂q. Vectors that are given must be free of what the supports hold, and so are those that are
/// returned.
class SmallMotions {
 public:
  /// About q, under the loads at t (s). `cable` must outlive it.
  SmallMotions(const Cable& cable, const Eigen::VectorXd& q, double t);

  const Cable& cable() const { return cable_; }
  const Eigen::VectorXd& state() const { return q_; }

  bool has_rates() const { return rates_.has_value(); }  ///< D is not 0
  bool has_symmetric_stiffness() const { return !of_loads_.has_value(); }

  void mass_times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;       ///< y := M x
  void rates_times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;      ///< y := D x
  void stiffness_times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;  ///< y := K x

  /// Xᵀ Kₛ X, a column of X each and Kₛ being the symmetric part of K, in which nothing cancels but what does
  /// in the strains.
  Eigen::MatrixXd stiffness_of(const Eigen::MatrixXd& X) const;
  /// xᵀ K x of a vector; 0 where that is round-off.
  double stiffness_along(const Eigen::VectorXd& x) const;
  /// xᵀ M x.
  double mass_of(const Eigen::VectorXd& x) const;

  /// Factors Kₛ + shift M. Returns the node at which it is singular;
  /// nothing if all is well.
  [[nodiscard]] std::optional<int> factor(double shift, BlockLu<double>& factors) const;
  /// Eigenvalues of Kₛ φ = μ M φ below a number, 1/s²; nothing where they cannot be counted.
  std::optional<int> count_below(double square) const;
  /// Factors λ² M + λ D + K, λ in 1/s.
  [[nodiscard]] std::optional<int> factor(std::complex<double> exponent,
                                          BlockLu<std::complex<double>>& factors) const;

 private:
  BlockTridiagonal symmetric(double shift) const;
  Eigen::MatrixXd turned(Eigen::MatrixXd X) const;  // S X

  const Cable& cable_;
  Eigen::VectorXd q_;
  StrainStiffness strains_;
  Eigen::Matrix3d spin_;  // S, 1/s
  BlockTridiagonal mass_, stiffness_;
  /// Of loads that depend on how the cable lies, which is no symmetric part of K.
  std::optional<GeneralBlockTridiagonal<double>> of_loads_, rates_;
};

/// Rigid-body motions (a column each, φᵀ M φ = 1, translations first) that neither supports nor forces
/// resist.
Eigen::MatrixXd free_rigid_motions(const SmallMotions& motions);

}  // namespace plumb
