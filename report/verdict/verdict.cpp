#include "report/verdict/verdict.h"

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
    verdict.coverage = error.coverage;
    if (const std::string other = difference(reference.cable, run.loaded.spec.cable); !other.empty()) {
      verdict.detail = "the reference is for another cable: " + other;
    } else if (const std::string failure = failure_of(run, error.given_run); !failure.empty()) {
      // What came before may be right by chance; a run that failed vouches for nothing.
      verdict.detail = failure;
    } else if (!error.coverage.enough()) {
      verdict.detail = error.coverage.lacking;
    } else {
      verdict.value = use.norm == Norm::max ? error.max : error.rms;
      verdict.status = within(verdict.value, verdict.limit) ? VerdictStatus::passed : VerdictStatus::failed;
      verdict.detail = fmt::format("the greatest {}; {}",
                                   error.coverage.of_modes ? fmt::format("of mode {:g}", error.max_time)
                                                           : fmt::format("at {:.4g} s", error.max_time),
                                   in_words(error.coverage, error.unit));
      hold_to_scale(verdict, error.scale, "the reference");
    }
    verdict.message = verdict.status == VerdictStatus::not_run
                          ? verdict.detail
                          : fmt::format("{:.3g} {} of {:.3g} {} allowed, {}", verdict.value, error.unit,
                                        verdict.limit, error.unit, verdict.detail);
    result.push_back(std::move(verdict));
  }
  return result;
}

void hold_to_scale(Verdict& verdict, const Magnitude& scale, const std::string& of) {
  if (verdict.status != VerdictStatus::passed) return;
  const double greatest = std::max(scale.size, scale.reach);
  if (greatest > 0 && verdict.limit > greatest) {
    verdict.status = VerdictStatus::not_run;
    verdict.value = -1;
    verdict.detail = fmt::format(
        "its limit of {:.3g} {} is more than {} ever is, {:.3g} {}: a run that does nothing would be within "
        "it",
        verdict.limit, verdict.unit, of, greatest, verdict.unit);
  } else if (scale.reach > 0 && verdict.limit >= scale.reach) {
    verdict.detail +=
        fmt::format("; {} moves by {:.3g} {} only: one that stands still may be within the limit", of,
                    scale.reach, verdict.unit);
  }
}

bool within(double value, double limit) {
  return std::isfinite(value) && value >= 0 && value <= limit;
}

bool all_passed(const std::vector<Verdict>& verdicts) {
  return std::all_of(verdicts.begin(), verdicts.end(),
                     [](const Verdict& verdict) { return verdict.status == VerdictStatus::passed; });
}

}  // namespace plumb
