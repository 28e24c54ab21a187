#include "report/series_error.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/output/given_probes.h"

namespace plumb {
namespace {

/// A run as comparisons need it: when it is known, and what its probes see at any time between.
struct Source {
  std::optional<std::size_t> given_run;
  const std::vector<double>& outputs;
  std::function<ProbeTable(const std::vector<double>&)> at;
};

/// Times of a reference that a run has, by their rows, and how many within the case's end it has not.
struct Reached {
  std::vector<std::size_t> rows;
  std::vector<double> times;  // as the run has them
  std::size_t missed = 0;
  std::size_t interpolated = 0;
};

Reached reached_times(const Reference& reference, const std::vector<double>& outputs, double end) {
  const double tolerance = 1e-9 * end;
  Reached result;
  for (std::size_t row = 0; row < reference.times.size(); ++row) {
    const double t = reference.times[row];
    if (t > end + tolerance) continue;
    if (outputs.empty() || t < outputs.front() - tolerance || t > outputs.back() + tolerance) {
      ++result.missed;
      continue;
    }
    result.rows.push_back(row);
    const auto near = std::lower_bound(outputs.begin(), outputs.end(), t - tolerance);
    const bool own = near != outputs.end() && *near <= t + tolerance;
    // 0.3 s and 300 ms are the same time, but not the same number.
    result.times.push_back(own ? *near : t);
    if (!own) ++result.interpolated;
  }
  return result;
}

void add_errors(const Run& run, const Source& source, std::vector<SeriesError>& result) {
  const Case& spec = run.loaded.spec;
  for (std::size_t r = 0; r < spec.references.size(); ++r) {
    const Reference& reference = run.loaded.references[r];
    const Reached reached = reached_times(reference, source.outputs, spec.time.end);
    const ProbeTable seen = source.at(reached.times);
    for (const Comparison& pair : spec.references[r].compare) {
      const ReferenceSeries& series = *reference.find(pair.series);
      const Column* column = seen.find(pair.column);
      SeriesError error;
      error.given_run = source.given_run;
      error.reference = r;
      error.series = pair.series;
      error.column = pair.column;
      error.unit = series.unit;
      error.missed = reached.missed;
      if (column == nullptr) {
        error.missed += reached.rows.size();
        result.push_back(std::move(error));
        continue;
      }
      error.interpolated = reached.interpolated;
      for (std::size_t k = 0; k < reached.rows.size(); ++k) {
        error.times.push_back(reference.times[reached.rows[k]]);
        error.expected.push_back(series.values[reached.rows[k]]);
        error.difference.push_back(column->values[k] - error.expected.back());
      }
      const DifferenceNorms norms = norms_of(error.times, error.difference);
      error.max = norms.max;
      error.max_time = norms.max_time;
      error.rms = norms.rms;
      result.push_back(std::move(error));
    }
  }
}

Source source_of(const GivenRun& given, std::optional<std::size_t> given_run) {
  return {given_run, given.times, [&given](const std::vector<double>& times) { return probe(given, times); }};
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

std::vector<SeriesError> series_errors(const Run& run) {
  std::vector<SeriesError> result;
  const std::vector<GivenRun>& given = run.loaded.given_runs;
  const bool reports_given = reports_given_run(run.loaded.spec);
  add_errors(run,
             reports_given ? source_of(given.front(), {})
                           : Source{{},
                                    run.trajectory.times,
                                    [&](const std::vector<double>& times) {
                                      return probe(run.loaded.spec, run.trajectory, times);
                                    }},
             result);
  for (std::size_t k = reports_given ? 1 : 0; k < given.size(); ++k)
    add_errors(run, source_of(given[k], k), result);
  return result;
}

}  // namespace plumb
