#include "report/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/output/time_interpolation.h"

namespace plumb {

std::string_view word(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::verification:
      return "verification";
    case VerdictKind::validation:
      return "validation";
    case VerdictKind::regression:
      return "regression";
    case VerdictKind::performance:
      return "performance";
  }
  return "verification";
}

std::string_view word(VerdictStatus status) {
  switch (status) {
    case VerdictStatus::not_run:
      return "not run";
    case VerdictStatus::passed:
      return "passed";
    case VerdictStatus::failed:
      return "failed";
  }
  return "not run";
}

namespace {

/// The given run that an error is of, or nullptr for a run of Plumb's own.
const GivenRun* given_of(const SeriesError& error, const Run& run) {
  if (error.given_run) return &run.loaded.given_runs[*error.given_run];
  return reports_given_run(run.loaded.spec) ? &run.loaded.given_runs.front() : nullptr;
}

double longest_interval(const std::vector<double>& times) {
  double longest = 0;
  for (std::size_t k = 1; k < times.size(); ++k) longest = std::max(longest, times[k] - times[k - 1]);
  return longest;
}

/// Over how many times a distance was taken, where the greatest is, and what else must be known to judge it.
std::string where(const SeriesError& error, const Run& run) {
  std::string text = fmt::format("over {} of {} times, the greatest at {:.4g} s", error.times.size(),
                                 run.loaded.references[error.reference].times.size(), error.max_time);
  if (error.interpolated == 0) return text;
  const GivenRun* given = given_of(error, run);
  if (given == nullptr)
    return text + fmt::format("; {} of them interpolated between outputs {:.4g} s apart", error.interpolated,
                              run.loaded.spec.time.output_interval);
  return text + fmt::format("; {} of them interpolated {} between its own times, at most {:.4g} s apart",
                            error.interpolated, interpolation_in_words(given->times.size()),
                            longest_interval(given->times));
}

/// Why a given run cannot be held against a series.
std::string what_is_missing(const SeriesError& error, const std::string& name, const GivenRun& given) {
  if (given.find(error.column) == nullptr) return fmt::format("{} has no column {}", name, error.column);
  return fmt::format(
      "{} has {} of {} reference times: it is from {:.4g} to {:.4g} s, and nothing is extrapolated", name,
      error.times.size(), error.times.size() + error.missed, given.times.front(), given.times.back());
}

}  // namespace

std::vector<Verdict> verdicts(const Run& run, const std::vector<SeriesError>& errors) {
  std::vector<Verdict> result;
  for (const SeriesError& error : errors) {
    const ReferenceUse& use = run.loaded.spec.references[error.reference];
    const Reference& reference = run.loaded.references[error.reference];
    Verdict verdict;
    verdict.kind =
        reference.kind == ReferenceKind::published ? VerdictKind::validation : VerdictKind::verification;
    const std::string given = given_name(error, run.loaded.spec);
    const std::string of = given.empty() ? reported_name(run.loaded.spec) : given;
    verdict.name = (given.empty() ? "" : given + ": ") + use.name + ": " + error.column;
    verdict.criterion = fmt::format("{} |{} − {}| of {} ≤ {:.3g} {}", word(use.norm), of,
                                    reference.kind == ReferenceKind::published ? "published" : "computed",
                                    error.column, use.tolerance, error.unit);
    verdict.limit = use.tolerance;
    verdict.unit = error.unit;
    verdict.reason = use.reason;
    if (const std::string other = difference(reference.cable, run.loaded.spec.cable); !other.empty()) {
      verdict.detail = "the reference is for another cable: " + other;
    } else if (error.missed == 0 && error.times.empty()) {
      verdict.detail = fmt::format("no time of the reference is within the run, which ends at {:.4g} s",
                                   run.loaded.spec.time.end);
    } else if (const GivenRun* source = given_of(error, run); source != nullptr && error.missed > 0) {
      verdict.detail = what_is_missing(error, of, *source);
    } else if (error.missed > 0) {
      verdict.detail =
          fmt::format("the run ended at {:.4g} s and reached {} of {} reference times",
                      run.trajectory.end_time, error.times.size(), error.times.size() + error.missed);
    } else if (given.empty() && run.trajectory.outcome != Outcome::completed) {
      // What came before may be right by chance; a run that failed vouches for nothing.
      verdict.detail = fmt::format("the run ended early, {} at {:.4g} s", word(run.trajectory.outcome),
                                   run.trajectory.end_time);
    } else {
      verdict.value = use.norm == Norm::max ? error.max : error.rms;
      verdict.status = within(verdict.value, verdict.limit) ? VerdictStatus::passed : VerdictStatus::failed;
      verdict.detail = where(error, run);
    }
    verdict.message = verdict.status == VerdictStatus::not_run
                          ? verdict.detail
                          : fmt::format("{:.3g} {} of {:.3g} {} allowed, {}", verdict.value, error.unit,
                                        verdict.limit, error.unit, verdict.detail);
    result.push_back(std::move(verdict));
  }
  return result;
}

bool within(double value, double limit) {
  return std::isfinite(value) && value >= 0 && value <= limit;
}

bool all_passed(const std::vector<Verdict>& verdicts) {
  return std::all_of(verdicts.begin(), verdicts.end(),
                     [](const Verdict& verdict) { return verdict.status == VerdictStatus::passed; });
}

}  // namespace plumb
