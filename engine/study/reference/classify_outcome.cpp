#include "engine/study/reference/classify_outcome.h"

#include <cmath>

#include "engine/study/reference/node_distance.h"

namespace plumb {

Judgement classify_outcome(const Trajectory& run, const Trajectory& reference, double tolerance,
                           double horizon) {
  Judgement result;
  result.outcome = run.outcome;
  if (run.outcome != Outcome::completed) return result;
  result.error = node_distance(run, reference, horizon);
  if (result.error < 0) return result;
  double until = -1;
  for (std::size_t k = 0; k < run.times.size() && k < reference.times.size(); ++k)
    if (run.times[k] <= horizon) until = run.times[k];
  if (!(until > run.times.front())) {
    // At the start alone every run is where its reference is.
    result.error = -1;
    return result;
  }
  result.judged_until = until;
  // Written so that what is not a number is inaccurate.
  bool accurate = std::isfinite(result.error) && result.error <= tolerance;
  if (result.judged_until < run.times.back()) {
    const double first = run.energies.front().total(), scale = run.kinetic_scale();
    for (const Energies& energies : run.energies)
      accurate =
          accurate && std::isfinite(scale) && std::abs(energies.total() - first) <= energy_share * scale;
  }
  result.outcome = accurate ? Outcome::accurate : Outcome::inaccurate;
  return result;
}

}  // namespace plumb
