#include "engine/integrate/fixed_step_method.h"

#include <utility>

#include "engine/integrate/state_at.h"

namespace plumb {

FixedStepMethod::FixedStepMethod(double h, Dynamics& dynamics, const State& start)
    : h_(h), dynamics_(dynamics), before_(start), now_(start) {}

StepResult FixedStepMethod::step(double stop) {
  // A sliver of a step left by round-off is not taken: the step before it reaches the stop.
  constexpr double sliver = 1e-9;
  double next = h_ * static_cast<double>(taken_ + 1);
  if (next > stop - sliver * h_) next = stop;
  const StepResult result = advance(next - now_.t, now_, before_);
  if (!result.ok()) return result;
  before_.t = next;
  std::swap(before_, now_);
  ++taken_;
  return result;
}

void FixedStepMethod::interpolate(double t, State& at) const {
  hermite_in_time(before_, now_, t, at);
}

}  // namespace plumb
