#include "report/verdict/given_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/read/given_probes.h"
#include "report/verdict/series_error.h"

namespace plumb {
namespace {

/// The times (s) of both, one only where they have the same but for rounding.
std::vector<double> times_of_both(const std::vector<double>& reported, const std::vector<double>& given) {
  std::vector<double> times = reported;
  for (const double t : given)
    if (const std::optional<KnownTime> known = known_time(reported, t); !known || !known->output)
      times.push_back(t);
  std::sort(times.begin(), times.end());
  return times;
}

void add_distances(const Run& run, std::size_t k, std::vector<GivenDistance>& result) {
  const GivenRunSpec& spec = run.loaded.spec.given_runs[k];
  const std::vector<double>&reported_outputs = outputs_of(run, {}), &given_outputs = outputs_of(run, k);
  Demand demand{times_of_both(reported_outputs, given_outputs), spec.coverage, "the two runs", "", "", 0};
  const std::vector<double> claimed = demand.claimed_times();
  const SampledRun given = sample_of(run, k, claimed), reported = sample_of(run, {}, claimed);
  const bool repeats = same_run(run.probes, probe(run.loaded.given_runs[k]));
  for (const Column& column : given.values.columns) {
    const Column* other = reported.values.find(column.name);
    if (other == nullptr) continue;
    Magnitude scale;
    for (const ProbeTable* values : {&given.values, &reported.values})
      for (const Column& any : values->columns)
        if (any.unit == column.unit) scale.add(any.values);
    demand.column = column.name;
    demand.unit = column.unit;
    const auto tolerance = spec.tolerances.find(column.name);
    demand.tolerance =
        tolerance != spec.tolerances.end() ? tolerance->second : std::numeric_limits<double>::infinity();
    const Covered covered = cover(
        demand, {{run_name(run, k), given_outputs, given}, {run_name(run, {}), reported_outputs, reported}});
    GivenDistance distance{k, column.name, column.unit, covered.coverage, {}, {}, 0, 0, 0, scale, repeats};
    for (std::size_t row = 0; row < covered.times.size(); ++row) {
      distance.times.push_back(claimed[covered.times[row]]);
      distance.difference.push_back(column.values[covered.rows[0][row]] -
                                    other->values[covered.rows[1][row]]);
    }
    const DifferenceNorms norms = norms_of(distance.times, distance.difference);
    distance.max = norms.max;
    distance.max_time = norms.max_time;
    distance.rms = norms.rms;
    result.push_back(std::move(distance));
  }
}

}  // namespace

std::vector<GivenDistance> given_distances(const Run& run) {
  std::vector<GivenDistance> result;
  for (std::size_t k = reports_given_run(run.loaded.spec) ? 1 : 0; k < run.loaded.given_runs.size(); ++k)
    add_distances(run, k, result);
  return result;
}

std::string in_words(const GivenDistance& distance) {
  if (distance.times.empty()) return "not run: " + distance.coverage.lacking;
  return fmt::format("{:.3g} {} at {:.4g} s (RMS {:.3g} {}), {}", distance.max, distance.unit,
                     distance.max_time, distance.rms, distance.unit,
                     in_words(distance.coverage, distance.unit));
}

std::vector<Verdict> distance_verdicts(const Run& run, const std::vector<GivenDistance>& distances) {
  std::vector<Verdict> result;
  const Case& spec = run.loaded.spec;
  for (const GivenDistance& distance : distances) {
    const GivenRunSpec& given = spec.given_runs[distance.given_run];
    const auto tolerance = given.tolerances.find(distance.column);
    if (tolerance == given.tolerances.end()) continue;
    const std::string reported = reported_name(spec);
    Verdict verdict;
    verdict.kind = VerdictKind::verification;
    verdict.name = fmt::format("{}: {}: {}", given.name, reported, distance.column);
    verdict.criterion = fmt::format("max |{} − {}| of {} ≤ {:.3g} {}, code against code", given.name,
                                    reported, distance.column, tolerance->second, distance.unit);
    verdict.limit = tolerance->second;
    verdict.unit = distance.unit;
    verdict.reason = given.reason;
    verdict.coverage = distance.coverage;
    if (run.trajectory.outcome != Outcome::completed) {
      verdict.detail = fmt::format("the run of {} ended early, {} at {:.4g} s", reported,
                                   word(run.trajectory.outcome), run.trajectory.end_time);
    } else if (const std::string failure = failure_of(run, distance.given_run); !failure.empty()) {
      verdict.detail = failure;
    } else if (!distance.coverage.enough()) {
      verdict.detail = distance.coverage.lacking;
    } else if (distance.repeats) {
      verdict.detail = fmt::format("the numbers of {} are those of {}: one run does not confirm itself",
                                   given.name, reported);
    } else {
      verdict.value = distance.max;
      verdict.time = distance.max_time;
      verdict.status = within(verdict.value, verdict.limit) ? VerdictStatus::passed : VerdictStatus::failed;
      verdict.detail = fmt::format("the greatest at {:.4g} s; {}", distance.max_time,
                                   in_words(distance.coverage, distance.unit));
      hold_to_scale(verdict, distance.scale, "either run");
    }
    verdict.message = verdict.status == VerdictStatus::not_run
                          ? verdict.detail
                          : fmt::format("{:.3g} {} of {:.3g} {} allowed, {}", verdict.value, distance.unit,
                                        verdict.limit, distance.unit, verdict.detail);
    result.push_back(std::move(verdict));
  }
  return result;
}

}  // namespace plumb
