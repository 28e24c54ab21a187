#pragma once

#include <optional>
#include <string>

#include "engine/integrate/method.h"
#include "engine/model/mode_shapes.h"

namespace plumb {

/// How far a change of the coordinates turns a slope at most, or a chord over its length.
double greatest_turn(const Eigen::VectorXd& dq, double element_length);

/// A cable under a share of its load, as a problem of equilibrium: R(q, λ) = λ F + F₀ − ∂U/∂q = 0 with the
/// supports in, K = −∂R/∂q. F are the constant loads of the case together, beside which there are that share
/// of the others at that share of the duration (VariableLoads), which are left to LoadSteps alone; F₀ holds
/// the unloaded cable in the start that it is given, where this is not straight.
///
/// Where loads and supports are as good as symmetric about the axis of the straight cable, a bent one may be
/// turned about it for nothing. Such a turn is no disturbance: a spring holds one node against it, which
/// takes the 0 of the turn from the eigenvalues of K and leaves the signs of all others, and no correction
/// turns the cable.
class LoadedCable {
 public:
  /// `tolerance`: largest error left of a position, or of a slope times the element length, m.
  LoadedCable(Dynamics& dynamics, const Eigen::VectorXd& start, double tolerance);

  Dynamics& dynamics() { return dynamics_; }
  const Cable& cable() const { return dynamics_.cable(); }
  const Eigen::VectorXd& start() const { return start_; }
  const Eigen::VectorXd& load() const { return load_; }  ///< F, N and N m

  /// False where loads and supports are symmetric about the axis.
  bool has_a_side() const { return has_a_side_; }

  /// R of the equation above, N and N m. Returns an element whose slope collapsed.
  std::optional<int> residual(const Eigen::VectorXd& q, double share, Eigen::VectorXd& result);
  /// Factors K, in which the share only counts where loads depend on how the cable lies. Returns the node at
  /// which it is singular; nothing if all is well.
  std::optional<int> factor(const Eigen::VectorXd& q, double share = 1);
  /// x := K⁻¹ x with the K that was factored last.
  void solve(Eigen::VectorXd& x) const;
  /// Share of what a force moves with the K at q, factored last, that is round-off; 0 without a force.
  double share_of_round_off(const Eigen::VectorXd& q, const Eigen::VectorXd& force) const;
  /// Negative eigenvalues of the K that was factored last, -1 where they cannot be counted.
  int negative_eigenvalues() const { return dynamics_.negative_eigenvalues().value_or(-1); }

  /// Newton's iteration under that share of the load from q, which must be near an equilibrium, with whole
  /// corrections. Leaves K factored there.
  StepResult settle(Eigen::VectorXd& q, double share, int iterations);
  /// Whether Newton's iteration is where it should be after a correction of that size (m), with the one
  /// before it and the residual that it left: where the correction is within the tolerance (m) and the
  /// residual within round-off or a millionth of the load; or where corrections are no longer smaller, as the
  /// residual is within round-off.
  bool has_converged(double correction, double last, const Eigen::VectorXd& residual, double share,
                     double tolerance) const;
  double tolerance() const { return tolerance_; }  ///< m

  /// U − (λ F + F₀)·q, J.
  double potential(const Eigen::VectorXd& q, double share) const;

  /// Scalar product of changes of the coordinates: the mean over the nodes of that of displacements, in
  /// lengths of the cable, and of slopes.
  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  double norm(const Eigen::VectorXd& a) const { return std::sqrt(dot(a, a)); }
  /// Greatest distance of a node from its place at the start, m.
  double displacement(const Eigen::VectorXd& q) const;
  /// True where an element of q points the other way than in `before`. A pressed bar turned inside out is in
  /// equilibrium, but not with what it was.
  static bool is_reversed(const Eigen::VectorXd& before, const Eigen::VectorXd& q);

  StepResult singular(int node) const;
  static StepResult collapsed(int element);

 private:
  /// Greatest force on a node, N, that of a slope as moment over the length of an element.
  double greatest(const Eigen::VectorXd& residual) const;
  Instant at(double share) const {
    return {.t = share * dynamics_.times().duration, .load = share, .still = true};
  }
  void take_out_turn(Eigen::VectorXd& x) const;

  Dynamics& dynamics_;
  Eigen::VectorXd start_, load_, bias_;
  double tolerance_;       // m
  double residual_floor_;  // N: round-off
  bool is_symmetric_;      // about the axis, or as good as
  bool has_a_side_;
  Eigen::VectorXd turn_;  // about the axis, of unit norm; nothing where there is none
  Eigen::VectorXd residual_, change_;
};

}  // namespace plumb
