#pragma once

#include <Eigen/Core>

namespace plumb {

/// Chooses steps so that the estimated error of each is within the tolerances: a proportional-integral
/// control (Gustafsson 1991; Hairer and Wanner 1996, section IV.2).
class StepControl {
 public:
  /// An error in position is held against (rtol + atol) L, one in a slope against rtol + atol: fixed scales,
  /// so that a coordinate that passes through 0 costs no steps. `order` of the method; L in m. With a
  /// `duration` (s) above 0 these are what all errors within it may add up to, with 0 what each may be:
  /// methods of low order take so many steps that errors within the tolerance add up to a multiple of it.
  StepControl(double rtol, double atol, double length, int order, double duration = 0);

  /// Size of an error in q of a step of h (s) against the tolerances; 1 is just allowed.
  double size(const Eigen::VectorXd& error, double h) const;

  /// How many times greater tolerances would have to be for steps that many times longer.
  double tolerance_ratio(double steps) const;

  /// The first step for accelerations a at the start, s; `end` is the end of the run, s.
  double first_step(const Eigen::VectorXd& a, double end) const;

  /// The step after one of h whose error had this size, accepted (≤ 1) or not.
  double next(double h, double size) const;

  /// A step of full length with an error of this size counts for those that follow.
  void accept(double size);

  /// The step after one of h that could not be completed.
  static double after_failure(double h) { return h / 4; }

 private:
  double position_scale_;  // m
  double slope_scale_;
  double duration_;  // s; 0: of an error in a step
  double exponent_;  // of the length of a step, over tolerances
  double last_ = 1;
};

}  // namespace plumb
