#include "engine/integrate/sundials/arkode_method.h"

namespace plumb::sundials {

ArkodeMethod::ArkodeMethod(const MethodSpec& spec, Dynamics& dynamics, const State& start)
    : LibraryMethod(dynamics, start) {
  if (spec.step) steps_.emplace(*spec.step);
}

int ArkodeMethod::evolve(double stop, double& reached) {
  if (!steps_) {
    stop_at(stop);
    return take_step(stop, reached);
  }
  const FixedSteps::Step next = steps_->next(state().t, stop);
  fix_step(next.h);
  const int flag = take_step(next.end, reached);
  if (flag < 0) return flag;
  steps_->take();
  // The library adds up its steps; the difference is round-off, and is not carried along.
  reached = next.end;
  return flag;
}

}  // namespace plumb::sundials
