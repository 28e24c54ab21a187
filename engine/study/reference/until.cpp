#include "engine/study/reference/until.h"

#include <algorithm>

namespace plumb {

Trajectory until(const Trajectory& run, double end) {
  constexpr double round_off = 1e-9;
  const double limit = end * (1 + round_off);
  const auto kept = std::upper_bound(run.times.begin(), run.times.end(), limit) - run.times.begin();
  if (kept == std::ssize(run.times) && run.end_time <= limit) return run;
  Trajectory part;
  part.elements = run.elements;
  part.element_length = run.element_length;
  part.outcome = run.outcome;
  part.message = run.message;
  part.end_time = run.end_time;
  if (run.outcome == Outcome::completed || run.end_time > limit) {
    part.outcome = Outcome::completed;
    part.message.clear();
    part.end_time = end;
  }
  part.times.assign(run.times.begin(), run.times.begin() + kept);
  part.q.assign(run.q.begin(), run.q.begin() + kept);
  part.v.assign(run.v.begin(), run.v.begin() + kept);
  part.energies.assign(run.energies.begin(), run.energies.begin() + kept);
  return part;
}

}  // namespace plumb
