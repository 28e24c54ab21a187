#include "engine/run/run.h"

#include <utility>

#include "engine/integrate/method_info.h"
#include "engine/read/given_probes.h"

namespace plumb {

bool has_modes(const Run& run) {
  const MethodInfo* info = find_method(run.loaded.spec.method.name);
  return info != nullptr && info->timeless;
}

Run reported_run(LoadedCase loaded, Provenance provenance) {
  const GivenRun& given = loaded.given_runs.at(0);
  Trajectory trajectory;
  trajectory.outcome = given.ending.failed() ? outcome_named(given.ending.outcome) : Outcome::completed;
  if (given.ending.failed()) trajectory.message = given.ending.message;
  trajectory.times = given.times;
  trajectory.end_time = given.times.back();
  ProbeTable probes = probe(given);
  return {std::move(loaded), std::move(trajectory), std::move(probes), std::move(provenance)};
}

}  // namespace plumb
