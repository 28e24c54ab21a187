#include "report/given_distance.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/output/given_probes.h"
#include "report/series_error.h"

namespace plumb {
namespace {

std::vector<double> within(const std::vector<double>& times, double from, double to) {
  return {std::lower_bound(times.begin(), times.end(), from),
          std::upper_bound(times.begin(), times.end(), to)};
}

ProbeTable reported_at(const Run& run, const std::vector<double>& times) {
  return reports_given_run(run.loaded.spec) ? probe(run.loaded.given_runs.front(), times)
                                            : probe(run.loaded.spec, run.trajectory, times);
}

void add_distances(const Run& run, std::size_t k, std::vector<GivenDistance>& result) {
  const GivenRun& given = run.loaded.given_runs[k];
  const std::vector<double>& reported = run.trajectory.times;
  std::vector<double> times;
  std::string times_of;
  if (!reported.empty()) {
    const double from = std::max(given.times.front(), reported.front());
    const double to = std::min(given.times.back(), reported.back());
    times = within(given.times, from, to);
    times_of = run.loaded.spec.given_runs[k].name;
    // The finer of the two loses less between its times.
    if (std::vector<double> fewer = within(reported, from, to);
        times.empty() || (!fewer.empty() && fewer.size() < times.size())) {
      times = std::move(fewer);
      times_of = reported_name(run.loaded.spec);
    }
  }
  const ProbeTable a = probe(given, times), b = reported_at(run, times);
  for (const Column& column : a.columns) {
    const Column* other = b.find(column.name);
    if (other == nullptr) continue;
    GivenDistance distance{k, column.name, column.unit, times, {}, times_of, 0, 0, 0};
    for (std::size_t row = 0; row < times.size(); ++row)
      distance.difference.push_back(column.values[row] - other->values[row]);
    const DifferenceNorms norms = norms_of(times, distance.difference);
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
  if (distance.times.empty()) return "not run: the two runs share no time";
  return fmt::format("{:.3g} {} at {:.4g} s (RMS {:.3g} {})", distance.max, distance.unit, distance.max_time,
                     distance.rms, distance.unit);
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
    const double tail = 1e-9 * spec.time.end;
    const std::vector<double>& mine = run.trajectory.times;
    const std::vector<double>& other = run.loaded.given_runs[distance.given_run].times;
    if (run.trajectory.outcome != Outcome::completed) {
      verdict.detail = fmt::format("the run of {} ended early, {} at {:.4g} s", reported,
                                   word(run.trajectory.outcome), run.trajectory.end_time);
    } else if (distance.times.empty()) {
      verdict.detail = "the two runs share no time";
    } else if (other.back() < mine.back() - tail && other.back() < spec.time.end - tail) {
      verdict.detail = fmt::format("{} ends at {:.4g} s, before {:.4g} s", given.name, other.back(),
                                   std::min(mine.back(), spec.time.end));
    } else {
      verdict.value = distance.max;
      verdict.status = within(verdict.value, verdict.limit) ? VerdictStatus::passed : VerdictStatus::failed;
      verdict.detail = fmt::format("over the {} times of {} in {:.4g} to {:.4g} s, the greatest at {:.4g} s",
                                   distance.times.size(), distance.times_of, distance.times.front(),
                                   distance.times.back(), distance.max_time);
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
