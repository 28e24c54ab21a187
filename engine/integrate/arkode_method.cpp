#include "engine/integrate/arkode_method.h"

namespace plumb::sundials {

ArkodeMethod::ArkodeMethod(const MethodSpec& spec, Dynamics& dynamics, const State& start)
    : LibraryMethod(dynamics, start), fixed_step_(spec.step) {}

int ArkodeMethod::evolve(double stop, double& reached) {
  if (!fixed_step_) {
    stop_at(stop);
    return take_step(stop, reached);
  }
  // A sliver of a step left by round-off is not taken: the step before it reaches the stop.
  constexpr double sliver = 1e-9;
  double next = *fixed_step_ * static_cast<double>(taken_ + 1);
  if (next > stop - sliver * *fixed_step_) next = stop;
  fix_step(next - state().t);
  const int flag = take_step(next, reached);
  if (flag < 0) return flag;
  ++taken_;
  // The library adds up its steps; the difference is round-off, and is not carried along.
  reached = next;
  return flag;
}

}  // namespace plumb::sundials
