#include "engine/study/reference/comparable_times.h"

#include <algorithm>

#include "engine/run/sampled_run.h"

namespace plumb {

ComparableTimes comparable_times(const Run& run, const ReferenceUse& use, const Reference& reference) {
  SampledRun sampled = sample(run.loaded.spec, run.trajectory, reference.times);
  add_aggregates(use.compare, run.probes, sampled);
  ComparableTimes comparable;
  for (std::size_t k = 0; k < sampled.times.size(); ++k) {
    const std::size_t row = sampled.rows[k];
    if (!use.coverage.has(reference.times[row]) ||
        !std::all_of(use.compare.begin(), use.compare.end(), [&](const Comparison& pair) {
          return bearable(sampled.errors.find(pair.column)->values[k], use.tolerance);
        }))
      continue;
    comparable.rows.push_back(row);
    comparable.times.push_back(sampled.times[k].time);
  }
  return comparable;
}

}  // namespace plumb
