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
    case VerdictStatus::another_model:
      return "another model";
  }
  return "not run";
}

int urgency(VerdictStatus status) {
  const auto* const found = std::find(statuses_by_urgency.begin(), statuses_by_urgency.end(), status);
  return static_cast<int>(found - statuses_by_urgency.begin());
}

namespace {

/// "at 0.5 s", "of mode 3"
std::string place_of(double time, const Coverage& coverage) {
  return fmt::format("{} {:.4g}{}", coverage.of_modes ? "of mode" : "at", time,
                     coverage.of_modes ? "" : " s");
}

/// It passed, and says nothing.
void take_back(Verdict& verdict, std::string why) {
  verdict.status = VerdictStatus::not_run;
  verdict.value = verdict.time = -1;
  verdict.detail = std::move(why);
}

/// Takes back that a distance passed to figures that are known no better than not at all.
void hold_to_uncertainty(Verdict& verdict, double half_width, const Magnitude& scale) {
  const double greatest = std::max(scale.size, scale.reach);
  if (verdict.status != VerdictStatus::passed || !(greatest > 0) || half_width < greatest) return;
  take_back(verdict,
            fmt::format(
                "the uncertainty of the reference, {:.3g} {}, is no less than all that it ever is, {:.3g} {}",
                half_width, verdict.unit, greatest, verdict.unit));
}

/// What was found of the printed figures: "the print is up to 0.03 m (3.3 %) off the exact figures, at 1 s".
std::string print_in_words(const SeriesError& error) {
  const PrintError& print = *error.print;
  if (print.max <= print.uncertainty) return "the print is exact to the uncertainty of the exact figures";
  return fmt::format(
      "the print is up to {:.3g} {}{} off the exact figures, {}", print.max, error.unit,
      print.greatest > 0 ? fmt::format(" ({:.2g} % of the greatest)", 100 * print.max / print.greatest) : "",
      place_of(print.max_time, error.coverage));
}

/// What is different in the model of a reference, and by how much that moves the figures.
std::string model_in_words(const SeriesError& error, const Reference& reference) {
  std::string text = "of another model: ";
  for (const std::string& difference : reference.model->differences)
    text += (&difference == &reference.model->differences.front() ? "" : "; ") + difference;
  if (const auto stated = reference.find(error.series)->model_error)
    text +=
        fmt::format("; this moves it by {:.3g} {} ({})", *stated, error.unit, reference.model->error_basis);
  return text;
}

}  // namespace

std::vector<Verdict> verdicts(const Run& run, const std::vector<SeriesError>& errors) {
  std::vector<Verdict> result;
  for (const SeriesError& error : errors) {
    const ReferenceUse& use = run.loaded.spec.references[error.reference];
    const Reference& reference = run.loaded.references[error.reference];
    const bool published = reference.kind == ReferenceKind::published && !error.exact;
    const bool other_model = reference.model && !error.exact;
    Verdict verdict;
    verdict.kind = published ? VerdictKind::validation : VerdictKind::verification;
    const std::string given = given_name(error, run.loaded.spec);
    const std::string of = given.empty() ? reported_name(run.loaded.spec) : given;
    verdict.name = fmt::format("{}{}: {}{}", given.empty() ? "" : given + ": ", use.name,
                               error.exact ? "exact: " : "", error.column);
    verdict.limit = use.tolerance;
    // What is printed may be as far from the run as it is from what is right.
    if (error.print && !other_model)
      verdict.limit += use.norm == Norm::max ? error.print->max : error.print->rms;
    verdict.criterion = fmt::format("{} |{} − {}| of {} ≤ {:.3g} {}", word(use.norm), of,
                                    error.exact ? "exact"
                                    : published ? "published"
                                                : "computed",
                                    error.column, verdict.limit, error.unit);
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
      verdict.status = other_model                            ? VerdictStatus::another_model
                       : within(verdict.value, verdict.limit) ? VerdictStatus::passed
                                                              : VerdictStatus::failed;
      if (!error.coverage.of_modes && std::isfinite(error.max_time)) verdict.time = error.max_time;
      verdict.detail = fmt::format("the greatest {}; {}", place_of(error.max_time, error.coverage),
                                   in_words(error.coverage, error.unit));
      hold_to_scale(verdict, error.scale, "the reference");
      const ReferenceSeries& series = *reference.find(error.series);
      hold_to_uncertainty(verdict, error.exact ? series.exact_uncertainty : series.uncertainty, error.scale);
      if (error.print) verdict.detail += "; " + print_in_words(error);
      if (other_model) verdict.detail += "; " + model_in_words(error, reference);
    }
    verdict.message = verdict.status == VerdictStatus::not_run ? verdict.detail
                      : verdict.status == VerdictStatus::another_model
                          ? fmt::format("{:.3g} {}, {}", verdict.value, error.unit, verdict.detail)
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
    take_back(
        verdict,
        fmt::format(
            "its limit of {:.3g} {} is more than {} ever is, {:.3g} {}: a run that does nothing would be "
            "within it",
            verdict.limit, verdict.unit, of, greatest, verdict.unit));
  } else if (scale.reach > 0 && verdict.limit >= scale.reach) {
    verdict.detail +=
        fmt::format("; {} moves by {:.3g} {} only: one that stands still may be within the limit", of,
                    scale.reach, verdict.unit);
  }
}

bool within(double value, double limit) {
  return std::isfinite(value) && value >= 0 && value <= limit;
}

long count_of(const std::vector<Verdict>& verdicts, VerdictStatus status) {
  return std::count_if(verdicts.begin(), verdicts.end(),
                       [&](const Verdict& verdict) { return verdict.status == status; });
}

bool all_passed(const std::vector<Verdict>& verdicts) {
  return count_of(verdicts, VerdictStatus::failed) == 0 && count_of(verdicts, VerdictStatus::not_run) == 0;
}

bool all_met(const std::vector<Verdict>& verdicts) {
  return all_passed(verdicts) && count_of(verdicts, VerdictStatus::passed) > 0;
}

}  // namespace plumb
