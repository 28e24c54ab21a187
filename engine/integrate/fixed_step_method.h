#pragma once

#include "engine/integrate/method.h"

namespace plumb {

/// The frame of a one-step method with a fixed step: a method of this kind only says how to advance a state
/// by h. Only the step that ends the run may be shorter. Times are n h, not a sum of h.
class FixedStepMethod : public Method {
 public:
  /// `h`: s, > 0.
  FixedStepMethod(double h, Dynamics& dynamics, const State& start);

  StepResult step(double stop) final;
  const State& state() const final { return now_; }

  /// Cubic Hermite interpolation of q from both ends' q and v, and of v from its derivative.
  void interpolate(double t, State& at) const final;

 protected:
  /// Sets `to` (q and v) to the state a time h after `from`.
  virtual StepResult advance(double h, const State& from, State& to) = 0;

  Dynamics& dynamics() { return dynamics_; }

 private:
  double h_;
  long taken_ = 0;
  Dynamics& dynamics_;
  State before_;
  State now_;
};

}  // namespace plumb
