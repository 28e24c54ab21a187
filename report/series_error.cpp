#include "report/series_error.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

void add_errors(const Run& run, std::optional<std::size_t> given_run, std::vector<SeriesError>& result) {
  const Case& spec = run.loaded.spec;
  for (std::size_t r = 0; r < spec.references.size(); ++r) {
    const ReferenceUse& use = spec.references[r];
    const Reference& reference = run.loaded.references[r];
    Demand demand{reference.times, use.coverage, "the reference", "", "", use.tolerance};
    const std::vector<double> claimed = demand.claimed_times();
    const SampledRun sampled = sample_of(run, given_run, claimed);
    for (const Comparison& pair : use.compare) {
      const ReferenceSeries& series = *reference.find(pair.series);
      SeriesError error;
      error.given_run = given_run;
      error.reference = r;
      error.series = pair.series;
      error.column = demand.column = pair.column;
      error.unit = demand.unit = series.unit;
      const Covered covered =
          cover(demand, {{run_name(run, given_run), outputs_of(run, given_run), sampled}});
      error.coverage = covered.coverage;
      const auto first =
          static_cast<std::size_t>(std::find_if(reference.times.begin(), reference.times.end(),
                                                [&](double t) { return use.coverage.has(t); }) -
                                   reference.times.begin());
      for (std::size_t k = 0; k < covered.times.size(); ++k) {
        error.times.push_back(claimed[covered.times[k]]);
        error.expected.push_back(series.values[first + covered.times[k]]);
        error.difference.push_back(sampled.values.find(pair.column)->values[covered.rows[0][k]] -
                                   error.expected.back());
      }
      const DifferenceNorms norms = norms_of(error.times, error.difference);
      error.max = norms.max;
      error.max_time = norms.max_time;
      error.rms = norms.rms;
      result.push_back(std::move(error));
    }
  }
}

/// The given run that is meant; nullptr for one of Plumb's own.
const GivenRun* given_of(const Run& run, std::optional<std::size_t> given_run) {
  if (given_run) return &run.loaded.given_runs[*given_run];
  return reports_given_run(run.loaded.spec) ? &run.loaded.given_runs.front() : nullptr;
}

}  // namespace

DifferenceNorms norms_of(const std::vector<double>& times, const std::vector<double>& difference) {
  DifferenceNorms norms;
  for (std::size_t k = 0; k < difference.size() && !std::isnan(norms.max); ++k) {
    const double distance = std::abs(difference[k]);
    if (distance <= norms.max) continue;
    norms.max = distance;
    norms.max_time = times[k];
  }
  if (!(norms.max > 0)) {
    norms.rms = norms.max;
    return norms;
  }
  // Scaled, so that a square does not overflow where the number itself does not.
  double squares = 0;
  for (const double x : difference) squares += x / norms.max * (x / norms.max);
  norms.rms = norms.max * std::sqrt(squares / static_cast<double>(difference.size()));
  return norms;
}

std::string given_name(const SeriesError& error, const Case& spec) {
  return error.given_run ? spec.given_runs[*error.given_run].name : "";
}

SampledRun sample_of(const Run& run, std::optional<std::size_t> given_run, const std::vector<double>& times) {
  const GivenRun* given = given_of(run, given_run);
  return given != nullptr ? sample(*given, times) : sample(run.loaded.spec, run.trajectory, times);
}

const std::vector<double>& outputs_of(const Run& run, std::optional<std::size_t> given_run) {
  const GivenRun* given = given_of(run, given_run);
  return given != nullptr ? given->times : run.trajectory.times;
}

std::string run_name(const Run& run, std::optional<std::size_t> given_run) {
  return given_run ? run.loaded.spec.given_runs[*given_run].name : reported_name(run.loaded.spec);
}

std::vector<SeriesError> series_errors(const Run& run) {
  std::vector<SeriesError> result;
  add_errors(run, {}, result);
  for (std::size_t k = reports_given_run(run.loaded.spec) ? 1 : 0; k < run.loaded.given_runs.size(); ++k)
    add_errors(run, k, result);
  return result;
}

}  // namespace plumb
