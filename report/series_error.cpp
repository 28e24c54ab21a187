#include "report/series_error.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

/// Reference times that the run reached, and how many within the case's end it did not.
struct Reached {
  std::vector<double> times;
  std::size_t missed = 0;
  std::size_t interpolated = 0;
};

Reached reached_times(const Reference& reference, const Run& run) {
  const double tolerance = 1e-9 * run.loaded.spec.time.end;
  const std::vector<double>& outputs = run.trajectory.times;
  Reached result;
  for (const double t : reference.times) {
    if (t > run.loaded.spec.time.end + tolerance) continue;
    if (outputs.empty() || t > outputs.back() + tolerance) {
      ++result.missed;
      continue;
    }
    result.times.push_back(std::min(t, outputs.back()));
    const auto near = std::lower_bound(outputs.begin(), outputs.end(), t - tolerance);
    if (near == outputs.end() || *near > t + tolerance) ++result.interpolated;
  }
  return result;
}

/// Sets the norms of the differences. A difference that is not a number makes them not a number, so that
/// nothing passes.
void measure(SeriesError& error) {
  for (std::size_t k = 0; k < error.times.size() && !std::isnan(error.max); ++k) {
    const double distance = std::abs(error.difference[k]);
    if (distance <= error.max) continue;
    error.max = distance;
    error.max_time = error.times[k];
  }
  if (!(error.max > 0)) {
    error.rms = error.max;
    return;
  }
  // Scaled, so that a square does not overflow where the number itself does not.
  double squares = 0;
  for (const double difference : error.difference)
    squares += difference / error.max * (difference / error.max);
  error.rms = error.max * std::sqrt(squares / static_cast<double>(error.times.size()));
}

}  // namespace

std::vector<SeriesError> series_errors(const Run& run) {
  std::vector<SeriesError> result;
  const Case& spec = run.loaded.spec;
  for (std::size_t r = 0; r < spec.references.size(); ++r) {
    const Reference& reference = run.loaded.references[r];
    const Reached reached = reached_times(reference, run);
    const ProbeTable seen = probe(spec, run.trajectory, reached.times);
    for (const Comparison& pair : spec.references[r].compare) {
      const ReferenceSeries& series = *reference.find(pair.series);
      SeriesError error;
      error.reference = r;
      error.series = pair.series;
      error.column = pair.column;
      error.unit = series.unit;
      error.times = reached.times;
      error.missed = reached.missed;
      error.interpolated = reached.interpolated;
      for (std::size_t k = 0; k < reached.times.size(); ++k) {
        error.expected.push_back(series.values[k]);
        error.difference.push_back(seen.find(pair.column)->values[k] - series.values[k]);
      }
      measure(error);
      result.push_back(std::move(error));
    }
  }
  return result;
}

}  // namespace plumb
