#pragma once

#include <Eigen/Core>

#include "engine/integrate/method.h"

namespace plumb {

/// What is solved for an acceleration x in an implicit step:
///   mass · M x = force · f(point) + known,   point = base + reach · x.
struct StageEquation {
  const Eigen::VectorXd& base;             ///< m and 1
  double reach = 0;                        ///< s², > 0
  double force = 1;                        ///< pure number, > 0
  double mass = 1;                         ///< pure number, > 0
  const Eigen::VectorXd* known = nullptr;  ///< N and N m; none: 0
  double position = 0;                     ///< how far q moves with x, s²: sets the scale of a correction
};

/// Newton's iteration for a StageEquation. Its matrix, mass · M + force · reach · K, is kept as long as the
/// iteration contracts well with it, over several steps if it does, and renewed where it does not. It ends
/// when what is left of the error, as judged by the contraction seen, is within the tolerance.
class ImplicitStage {
 public:
  /// Takes newton_tolerance and newton_iterations of `spec`.
  ImplicitStage(const MethodSpec& spec, Dynamics& dynamics);

  /// Solves for x, from the guess that x holds.
  StepResult solve(const StageEquation& equation, Eigen::VectorXd& x);

 private:
  double tolerance_;  // m
  int iterations_;
  Dynamics& dynamics_;
  bool has_factors_ = false;
  double factored_mass_ = 0, factored_stiffness_ = 0;
  Eigen::VectorXd guess_, point_, inertia_, residual_;
};

}  // namespace plumb
