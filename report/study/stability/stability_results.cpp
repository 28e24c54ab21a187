#include "report/study/stability/stability_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/study/stability/stability_json.h"
#include "engine/study/stability/step_in_words.h"
#include "report/base/escape.h"
#include "report/figure/outcome_style.h"
#include "report/study/stability/stability_conclusion.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

Verdict limit_verdict(const Stability& study, const CriticalStep& step) {
  const std::string where = study.parameter.empty()
                                ? counted(step.elements, "element", "elements")
                                : fmt::format("{}, {}", parameter_text(study, step.parameter),
                                              counted(step.elements, "element", "elements"));
  Verdict verdict;
  verdict.name = fmt::format("critical step: {}, {}", step.label, where);
  verdict.criterion = fmt::format("|found / predicted − 1| ≤ {:g} %", 100 * limit_tolerance);
  verdict.unit = "1";
  verdict.limit = limit_tolerance;
  verdict.reason = "Bisection stops at 1 %, and the fastest vibration changes along the motion.";
  const double off = deviation(step);
  if (std::isnan(off)) {
    verdict.detail = step.stable < 0 ? "no stable step was found" : "no unstable step was found";
    verdict.message = verdict.detail;
    return verdict;
  }
  verdict.value = std::abs(off);
  verdict.status = verdict.value <= verdict.limit ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail = fmt::format("found {} s, predicted {} s", setting_text(found_step(step), 3),
                               setting_text(predicted_step(step), 3));
  verdict.message = fmt::format("{:+.1f} %: {}", 100 * off, verdict.detail);
  return verdict;
}

Verdict reference_verdict(const Stability& study, const StabilityReference& reference, double horizon) {
  Verdict verdict;
  verdict.name = fmt::format("reference: {}{}{}, {:g} s", parameter_text(study, reference.parameter),
                             study.parameter.empty() ? "" : ", ",
                             counted(reference.elements, "element", "elements"), reference.duration);
  verdict.criterion = "two unlike methods agree to a tenth of the tolerance as long as runs are judged";
  verdict.unit = "s";
  verdict.limit = horizon;
  if (!(horizon > 0)) {
    verdict.detail = verdict.message = "neighbours part at once, so that no run can be judged";
    return verdict;
  }
  verdict.value = std::max(0.0, horizon - reference.trusted_until);
  verdict.status = reference.trusted_until >= horizon ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail = fmt::format("{} and {}", reference.first, reference.second);
  verdict.message = fmt::format("known until {:.4g} s of {:.4g} s, from {}", reference.trusted_until, horizon,
                                verdict.detail);
  verdict.reason = "A run cannot be judged by a motion that is not known itself.";
  return verdict;
}

/// The time up to which neighbours stay together, at most that of the reference.
double horizon_of(const TrajectoryDivergence& divergence, const StabilityReference& reference) {
  if (divergence.beyond_end || divergence.horizon < 0) return reference.duration;
  return std::min(divergence.horizon, reference.duration);
}

bool any_run(const Stability& study) {
  return std::any_of(study.maps.begin(), study.maps.end(), [](const OutcomeMap& map) {
    return std::any_of(map.points.begin(), map.points.end(),
                       [](const StabilityPoint& point) { return point.outcome != Outcome::not_run; });
  });
}

}  // namespace

double found_step(const CriticalStep& step) {
  return step.stable > 0 && step.unstable > 0 ? std::sqrt(step.stable * step.unstable) : -1;
}

double predicted_step(const CriticalStep& step) {
  if (step.limit_kind != LimitKind::vibration) return -1;
  const double worst = step.predicted.at_worst > 0 ? step.predicted.at_worst : step.predicted.at_start;
  return worst > 0 && std::isfinite(worst) ? worst : -1;
}

double deviation(const CriticalStep& step) {
  const double found = found_step(step), predicted = predicted_step(step);
  return found > 0 && predicted > 0 ? found / predicted - 1 : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Verdict> stability_verdicts(const Stability& study) {
  std::vector<Verdict> verdicts;
  for (const CriticalStep& step : study.critical_steps)
    if (predicted_step(step) > 0) verdicts.push_back(limit_verdict(study, step));
  for (std::size_t k = 0; k < study.references.size(); ++k) {
    const StabilityReference& reference = study.references[k];
    verdicts.push_back(reference_verdict(
        study, reference,
        k < study.divergences.size() ? horizon_of(study.divergences[k], reference) : reference.duration));
  }
  return verdicts;
}

std::string outcomes_in_words(const Stability& study) {
  std::string text;
  for (const OutcomeStyle& style : outcome_styles()) {
    long count = 0;
    for (const OutcomeMap& map : study.maps)
      count += std::count_if(map.points.begin(), map.points.end(),
                             [&](const StabilityPoint& point) { return point.outcome == style.outcome; });
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word(style.outcome));
  }
  return text;
}

StudyReport evaluate_stability(const StabilityStudyFile& file, const Stages& stages) {
  const Stability& study = file.result;
  StudyReport report{file.loaded, "where methods fail", study.provenance, stability_verdicts(study), stages};
  long points = 0;
  for (const OutcomeMap& map : study.maps) points += std::ssize(map.points);
  const std::string maps = counted(std::ssize(study.maps), "map", "maps");
  const StabilityConclusion conclusion = conclude(study);
  report.headline = conclusion.sentence;
  report.details = conclusion.details;
  report.counts = fmt::format("{} in {}: {}. {}", counted(points, "point", "points"), maps,
                              outcomes_in_words(study), met_in_words(report.verdicts));
  report.results["stability"] = stability_to_json(study);
  report.results["stability"]["conclusion"] = stability_conclusion_json(study);
  const bool run = any_run(study);
  report.suites.insert(report.suites.begin(),
                       {"study",
                        {{"stability: " + maps, run ? VerdictStatus::passed : VerdictStatus::not_run,
                          run ? "" : "no run was made"}}});
  report.before = fmt::format(
      "At {}{} over {:g} s, to {:g} m:\n\n", escape_markdown(parameter_text(study, study.parameter_value)),
      (study.parameter.empty() ? "" : ", ") + counted(study.elements, "element", "elements"), study.end,
      study.tolerance);
  for (const OutcomeMap& map : study.maps)
    if (map.axis == MapAxis::elements)
      report.before += fmt::format("- {}: {}\n", escape_markdown(map.label), escape_markdown(map.in_words));
  return report;
}

std::string parameter_text(const Stability& study, double value) {
  return study.parameter.empty() ? "" : fmt::format("{} = {:g}", study.parameter, value);
}

std::string place_in_words(const Stability& study, MapAxis axis) {
  std::string text;
  const auto add = [&](const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  };
  if (axis != MapAxis::parameter) add(parameter_text(study, study.parameter_value));
  if (axis != MapAxis::elements) add(counted(study.elements, "element", "elements"));
  if (axis != MapAxis::duration) add(fmt::format("{:g} s", study.end));
  return text;
}

std::string value_text(const Stability& study, MapAxis axis, double value) {
  if (axis == MapAxis::parameter) return parameter_text(study, value);
  if (axis == MapAxis::elements) return counted(std::lround(value), "element", "elements");
  return fmt::format("{:g} s", value);
}

}  // namespace plumb
