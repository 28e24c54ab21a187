#pragma once

#include <Eigen/Core>
#include <limits>

#include "engine/integrate/methods/newton.h"

namespace plumb {

/// Newton's iteration for an implicit stage (StageTerms). Its matrix, mass · M + force · (reach · K +
/// reach of the rates · C), is kept
/// as long as the iteration contracts well with it, over several steps if it does, and renewed where it does
/// not or where that would be cheaper. It ends when what is left of the error, as judged by the contraction
/// seen, is within the tolerance.
class ImplicitStage {
 public:
  /// Takes newton_tolerance and newton_iterations of `spec`. `weight`: as of leftover_of_a_step().
  ImplicitStage(const MethodSpec& spec, Dynamics& dynamics, double weight = 1);

  /// Solves for x, from the estimate in `stage`, of which x may not be a part; `at` are its time and rates.
  /// `position`: how far q moves with x, s², which sets the scale of a correction. `leftover`: what may be
  /// left of an error in position where that is less than newton_tolerance asks for, m. After a failure x is
  /// of no meaning.
  StepResult solve(const StageTerms& stage, const Instant& at, double position, Eigen::VectorXd& x,
                   double leftover = std::numeric_limits<double>::infinity());

 private:
  double tolerance_;  // m
  int iterations_;
  Dynamics& dynamics_;
  bool has_factors_ = false;
  MatrixWear wear_;
  TurnChoice turn_;
  double factored_mass_ = 0, factored_stiffness_ = 0, factored_reach_ = 0;
  Eigen::VectorXd next_;
};

}  // namespace plumb
