#include "report/study/work_precision/work_precision_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "engine/integrate/method_info.h"
#include "engine/study/work_precision/cheapest.h"
#include "report/base/escape.h"
#include "report/study/work_precision/compared_lines.h"
#include "report/study/work_precision/work_precision_conclusion.h"
#include "report/study/work_precision/work_precision_json.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

/// The order where one is stated: "2", not "1 to 5".
std::optional<double> single_order(const std::string& stated) {
  char* end = nullptr;
  const double order = std::strtod(stated.c_str(), &end);
  return !stated.empty() && *end == '\0' ? std::optional(order) : std::nullopt;
}

Verdict reference_verdict(const CertifiedReference& reference, const std::string& name) {
  Verdict verdict;
  verdict.name = name;
  verdict.criterion = "two unlike methods agree to a tenth of the smallest error drawn";
  verdict.unit = "m";
  verdict.limit = std::max(0.0, reference.smallest_error / 10);
  verdict.reason = "An error means nothing where its reference may be off by as much.";
  if (reference.agreement < 0 || reference.smallest_error < 0) {
    verdict.detail = reference.agreement < 0 ? reference.why_not : "no run has an error against it";
    verdict.message = verdict.detail;
    return verdict;
  }
  verdict.value = reference.agreement;
  verdict.status = reference.certified ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail = fmt::format("{} and {}", reference.first, reference.second);
  verdict.message =
      fmt::format("{:.2g} m of {:.2g} m allowed, between {}", verdict.value, verdict.limit, verdict.detail);
  if (!reference.certified)
    verdict.message +=
        fmt::format("; {}: errors below {:.2g} m mean nothing", reference.why_not, reference.floor);
  return verdict;
}

/// The lowest order that a curve may show: the stated one, or the stage order where all steps of the fit are
/// long against the fastest vibration.
double lowest_order(const WorkPrecision& study, const MethodCurve& curve, double stated) {
  const MethodInfo* method = find_method(curve.method);
  const bool reduced = method != nullptr && method->stage_order > 0 &&
                       study.fastest_frequency * curve.observed.smallest_step > 1;
  return reduced ? std::min<double>(stated, method->stage_order) : stated;
}

std::optional<Verdict> order_verdict(const WorkPrecision& study, const MethodCurve& curve) {
  const auto stated = single_order(curve.stated_order);
  const bool fixed_step = !curve.runs.empty() && study.runs[curve.runs.front()].method.step.has_value();
  if (curve.elements != study.fixed_elements || !stated || !fixed_step || curve.observed.order < 0) return {};
  const double lowest = lowest_order(study, curve, *stated);
  Verdict verdict;
  verdict.name = "order: " + curve.label;
  verdict.criterion = lowest < *stated ? fmt::format("observed order of {} within {:g} of {:g} to {:g}",
                                                     curve.label, order_tolerance, lowest, *stated)
                                       : fmt::format("|observed order − {:g}| of {} ≤ {:g}", *stated,
                                                     curve.label, order_tolerance);
  verdict.unit = "1";
  verdict.limit = order_tolerance;
  // Of an order that is not a number the distance must not be 0.
  verdict.value = std::isfinite(curve.observed.order)
                      ? std::max({0.0, curve.observed.order - *stated, lowest - curve.observed.order})
                      : curve.observed.order;
  verdict.status = within(verdict.value, verdict.limit) ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail =
      fmt::format("steps from {:.3g} to {:.3g} s", curve.observed.largest_step, curve.observed.smallest_step);
  verdict.message = fmt::format("order {:.3f} ± {:.3f} over {}", curve.observed.order,
                                curve.observed.deviation, verdict.detail);
  if (lowest < *stated)
    verdict.message += fmt::format(
        "; even the shortest is {:.3g} times 1/ω of the fastest vibration, which reduces the order "
        "towards the stage order {:g} (Hairer and Wanner 1996, section IV.15)",
        study.fastest_frequency * curve.observed.smallest_step, lowest);
  return verdict;
}

void append_cheapest(std::string& text, const std::string& title, const std::vector<CheapestRun>& cheapest) {
  if (cheapest.empty()) return;
  text += fmt::format("\n{}:\n\n", title);
  for (const CheapestRun& run : cheapest) text += fmt::format("- {}\n", escape_markdown(run.in_words));
}

}  // namespace

std::vector<Verdict> study_verdicts(const WorkPrecision& study) {
  std::vector<Verdict> verdicts;
  for (const CertifiedReference& reference : study.mesh_references)
    if (reference.elements == study.fixed_elements)
      verdicts.push_back(reference_verdict(
          reference, fmt::format("reference: {}", counted(reference.elements, "element", "elements"))));
  verdicts.push_back(reference_verdict(
      study.converged_reference,
      fmt::format("reference: converged, {} elements", study.converged_reference.elements)));
  for (const MethodCurve& curve : study.curves)
    if (auto verdict = order_verdict(study, curve)) verdicts.push_back(std::move(*verdict));
  return verdicts;
}

std::string failures_in_words(const WorkPrecision& study) {
  std::string text;
  const auto add = [&](long count, std::string_view what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  for (const Outcome outcome : outcomes())
    if (outcome != Outcome::completed)
      add(std::count_if(study.runs.begin(), study.runs.end(),
                        [&](const WorkPrecisionRun& run) { return run.outcome == outcome; }),
          word(outcome));
  add(std::count_if(study.runs.begin(), study.runs.end(),
                    [&](const WorkPrecisionRun& run) {
                      return run.completed() && run.time_error.tip_max > wrong_beyond * study.length;
                    }),
      "stable but wrong");
  return text;
}

std::vector<std::string> given_points_in_words(const WorkPrecision& study) {
  std::vector<std::string> lines;
  const auto distance = [](const ErrorNorms& norms, const char* from) {
    return norms.tip_max < 0 ? std::string() : fmt::format("{:.3g} m from {}", norms.tip_max, from);
  };
  for (const GivenCurve& curve : study.given_curves)
    for (const GivenPoint& point : curve.points) {
      const std::string time = distance(point.time_error, "the mesh of the case"),
                        total = distance(point.total_error, "the converged motion");
      lines.push_back(fmt::format(
          "{}: {}, {} on {}{}, {}: {}", curve.name, point.label, duration_in_words(point.seconds),
          machine_in_words(curve),
          study.is_scaled(curve) ? fmt::format(" ({} here)", duration_in_words(study.work(curve, point)))
                                 : "",
          counted(curve.threads, "thread", "threads"),
          !point.why_not.empty()          ? point.why_not
          : time.empty() && total.empty() ? "there is no reference for it"
                                          : time + (time.empty() || total.empty() ? "" : ", ") + total));
    }
  return lines;
}

StudyReport evaluate_study(const Study& study, const Stages& stages) {
  const WorkPrecision& result = study.result;
  StudyReport report{study.loaded, "speed against accuracy", result.provenance, study_verdicts(result),
                     stages};
  report.complete = std::any_of(result.runs.begin(), result.runs.end(),
                                [](const WorkPrecisionRun& run) { return run.completed(); });
  const std::string runs = counted(std::ssize(result.runs), "run", "runs");
  const std::string failures = failures_in_words(result);
  const WorkPrecisionConclusion conclusion = conclude(result);
  report.headline = conclusion.sentence;
  report.details = conclusion.details;
  report.counts =
      fmt::format("{} of {} on {}{}{}. {}", runs, counted(std::ssize(result.curves), "curve", "curves"),
                  counted(std::ssize(result.mesh_references), "mesh", "meshes"), failures.empty() ? "" : ": ",
                  failures, met_in_words(report.verdicts));
  report.results["work_precision"] = work_precision_json(result);
  report.suites.insert(
      report.suites.begin(),
      {"study",
       {{"work-precision of " + runs, report.complete ? VerdictStatus::passed : VerdictStatus::failed,
         report.complete ? "" : "no run completed"}}});
  append_cheapest(
      report.after,
      fmt::format("Cheapest time integration of {}", counted(result.fixed_elements, "element", "elements")),
      result.time_cheapest);
  append_cheapest(report.after, "Cheapest method and mesh against the converged solution",
                  result.total_cheapest);
  if (!result.given_curves.empty()) report.after += "\nOther programs:\n\n";
  for (const std::string& line : given_points_in_words(result))
    report.after += fmt::format("- {}\n", escape_markdown(line));
  return report;
}

}  // namespace plumb
