#include "report/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// Over how many times a distance was taken, where the greatest is, and what else must be known to judge it.
std::string where(const SeriesError& error, const Run& run) {
  std::string text = fmt::format("over {} of {} times, the greatest at {:.4g} s", error.times.size(),
                                 run.loaded.references[error.reference].times.size(), error.max_time);
  if (error.interpolated > 0)
    text += fmt::format("; {} of them interpolated between outputs {:.4g} s apart", error.interpolated,
                        run.loaded.spec.time.output_interval);
  return text;
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
    verdict.name = use.name + ": " + error.column;
    verdict.criterion = fmt::format("{} |Plumb − {}| of {} ≤ {:.3g} {}", word(use.norm),
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
    } else if (error.missed > 0) {
      verdict.detail =
          fmt::format("the run ended at {:.4g} s and reached {} of {} reference times",
                      run.trajectory.end_time, error.times.size(), error.times.size() + error.missed);
    } else if (run.trajectory.outcome != Outcome::completed) {
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
