#include "engine/integrate/fixed_step_method.h"

#include <utility>

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
  const double h = now_.t - before_.t, x = (t - before_.t) / h;
  const double x2 = x * x, x3 = x2 * x;
  at.t = t;
  at.q = (1 - 3 * x2 + 2 * x3) * before_.q + (3 * x2 - 2 * x3) * now_.q + h * (x - 2 * x2 + x3) * before_.v +
         h * (x3 - x2) * now_.v;
  at.v = (6 * x - 6 * x2) / h * (now_.q - before_.q) + (1 - 4 * x + 3 * x2) * before_.v +
         (3 * x2 - 2 * x) * now_.v;
}

}  // namespace plumb
