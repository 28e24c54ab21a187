#pragma once

#include "engine/integrate/fixed_steps.h"
#include "engine/integrate/method.h"
#include "engine/integrate/methods/step_control.h"

namespace plumb {

/// The frame of a one-step method: a method of this kind only says how to advance a state by h and, if its
/// step can be controlled, how far off that is. With [method] step the step is kept, and only the one that
/// ends the run may be shorter; times are n h, not a sum of h. With tolerances a StepControl chooses the
/// steps, and a step that fails is tried again shorter.
class OneStepMethod : public Method {
 public:
  /// `order`: of the method, for the control of its step.
  OneStepMethod(const MethodSpec& spec, int order, Dynamics& dynamics, const State& start);

  StepResult step(double stop) final;
  const State& state() const final { return now_; }
  long rejected_steps() const final { return rejected_; }

  /// Cubic Hermite interpolation of q from both ends' q and v, and of v from its derivative.
  void interpolate(double t, State& at) const override;

 protected:
  /// Sets `to` (q and v) to the state a time h after `from`. What the method carries from step to step must
  /// stay as it is until `accept`.
  virtual StepResult advance(double h, const State& from, State& to) = 0;

  /// Sets e to an estimate of the error in q of the step that `advance` has just made. Only asked of methods
  /// that take tolerances.
  virtual void estimate_error(double h, const State& from, const State& to, Eigen::VectorXd& e);

  /// The step that `advance` has just made counts.
  virtual void accept() {}

  Dynamics& dynamics() { return dynamics_; }
  bool controlled() const { return control_.has_value(); }
  /// What an iteration within a step of h (s) may leave of an error in position, m, so that velocities that
  /// are off by as much over h do not use up the tolerances; infinite with a fixed step.
  double allowed_leftover(double h) const;
  /// The state before the last step.
  const State& before() const { return before_; }

 private:
  StepResult fixed_step(double stop);
  StepResult controlled_step(double stop);
  void keep(double t);

  /// Whether steps have become so short that the run would take too many; says from which tolerance on it
  /// would not.
  StepResult refusal() const;
  void note_growth();

  double tolerance_;  // rtol + atol; 0: a fixed step
  double rtol_ = 0;
  FixedSteps steps_;
  std::optional<StepControl> control_;  // with tolerances
  double h_ = 0;                        // the controlled step, s; 0: not chosen yet
  double largest_step_ = 0;             // that it has clearly grown to, s
  int steps_since_growth_ = 0;
  long rejected_ = 0;
  Dynamics& dynamics_;
  State before_;
  State now_;
  Eigen::VectorXd error_;
};

}  // namespace plumb
