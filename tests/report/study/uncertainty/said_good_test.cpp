#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "report/document/junit_suites.h"
#include "report/document/regression.h"
#include "report/page/conclusion.h"
#include "report/study/economy/economy_results.h"
#include "report/study/economy/economy_section.h"
#include "report/study/economy/economy_text.h"
#include "report/study/stability/stability_results.h"
#include "report/study/sweep/sweep_results.h"
#include "report/study/uncertainty/budget_section.h"
#include "report/study/variants/variants_results.h"
#include "report/study/work_precision/work_precision_results.h"
#include "tests/report/made_run.h"
#include "tests/report/study/stability/made_stability.h"

// What each place of a report that can say something good says of nothing, of one point, of what is not a
// number and of what is infinite.
namespace plumb {
namespace said_good_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();

std::string status_of(const std::vector<Verdict>& verdicts, const std::string& name) {
  for (const Verdict& verdict : verdicts)
    if (verdict.name == name) return std::string(word(verdict.status));
  return "no verdict";
}

std::string swept(const std::string& name, std::vector<SweepRun> runs) {
  Sweep sweep;
  sweep.runs = std::move(runs);
  return status_of(sweep_verdicts(sweep), name);
}

SweepRun sweep_run(Outcome outcome) {
  SweepRun run;
  run.outcome = outcome;
  return run;
}

std::string motion_known(double trusted_until, double duration, double horizon, bool with_separation = true) {
  Stability study;
  StabilityReference reference;
  reference.elements = 4;
  reference.duration = duration;
  reference.trusted_until = trusted_until;
  study.references = {reference};
  if (with_separation) {
    TrajectoryDivergence divergence;
    divergence.horizon = horizon;
    study.divergences = {divergence};
  }
  return status_of(stability_verdicts(study), fmt::format("reference: 4 elements, {:g} s", duration));
}

std::string critical(double stable, double unstable, double predicted) {
  Stability study;
  CriticalStep step;
  step.label = "rk4";
  step.elements = 4;
  step.stable = stable;
  step.unstable = unstable;
  step.limit_kind = LimitKind::vibration;
  step.predicted = {predicted, predicted};
  study.critical_steps = {step};
  return status_of(stability_verdicts(study), "critical step: rk4, 4 elements");
}

std::string reference_of(double agreement, double smallest, bool certified) {
  WorkPrecision study;
  study.converged_reference.elements = 8;
  study.converged_reference.agreement = agreement;
  study.converged_reference.smallest_error = smallest;
  study.converged_reference.certified = certified;
  return status_of(study_verdicts(study), "reference: converged, 8 elements");
}

std::string picture_error(double estimate, bool holds) {
  Economy economy;
  economy.tolerance = 0.5;
  economy.holds = holds;
  TriedCandidate candidate;
  candidate.estimate = estimate;
  economy.tried = {candidate};
  economy.chosen = 0;
  return std::string(word(economy_verdict(economy).status));
}

std::string without_choice(bool left) {
  plumb::Run run = run_with("a");
  if (left) run.provenance.emplace_back(left_to_scene, "");
  return status_of(evaluate(run, {}, economy_sections(run, {})).verdicts, "picture error");
}

struct Need {
  double estimate = 0.1, true_error = 0.1, doubt = 0.01, seconds = 1e-3, safe = 1;
  bool certified = true;
};

std::string economical(const std::string& name, const Need& of) {
  EconomyStudy study;
  study.safe_seconds = of.safe;
  SceneNeed need;
  need.name = "picture";
  need.scene.size = {320, 180};
  need.certified = of.certified;
  need.reference_doubt = of.doubt;
  need.seconds = of.seconds;
  TriedCandidate candidate;
  candidate.estimate = of.estimate;
  candidate.true_error = of.true_error;
  need.economy.tolerance = 0.5;
  need.economy.tried = {candidate};
  need.economy.chosen = 0;
  study.needs = {need};
  return status_of(evaluate_economy(study, {}).verdicts, "picture: " + name);
}

std::string random_scenes(std::vector<RandomScene> scenes) {
  EconomyStudy study;
  study.scenes = std::move(scenes);
  return status_of(evaluate_economy(study, {}).verdicts, "random scenes");
}

RandomScene scene(bool holds, double true_error, double doubt = 0.01) {
  RandomScene made;
  made.holds = holds;
  made.tolerance = 1;
  made.true_error = true_error;
  made.reference_doubt = doubt;
  return made;
}

std::string varied(const std::vector<double>& found) {
  VariantsStudy study;
  VariantResult variant;
  variant.spec.name = "a";
  for (const double value : found) {
    ExpectationFound figure;
    figure.found = value;
    figure.expected.quantity = "end-time";
    figure.expected.within = 1;
    variant.spec.expectations.push_back(figure.expected);
    variant.expectations.push_back(figure);
  }
  study.result.variants = {variant};
  return status_of(evaluate_variants(study, {}).verdicts, "a");
}

std::string budgeted(const Document& distance, const std::string& outcome = "completed") {
  const Document run{{"outcome", outcome}, {"distances", distance}};
  const Document budget{{"reference", "book"},        {"left_out", ""}, {"series", Document::array()},
                        {"items", Document::array()}, {"base", run},    {"all_together", run}};
  const std::string words = budget_on_page().line(budget);
  const std::string before = "repeats it to ";
  const std::size_t at = words.find(before) + before.size();
  return words.substr(at, words.find(';') - at);
}

Document document() {
  static const Document made = document_of(evaluate(run_with("a"), {}), {});
  return made;
}

std::string concluded(Document of) {
  return conclusion_of(of).good ? "good" : "not good";
}

Document without_verdicts() {
  Document made = document();
  made["verdicts"] = Document::array();
  return made;
}

/// A reference may have any name, that of the baseline's verdicts too.
Document named_baseline() {
  Document made = document();
  made["references"][0]["name"] = "baseline";
  made["verdicts"][0]["status"] = "not run";
  Document moved = made["verdicts"][0];
  moved["kind"] = "regression";
  moved["name"] = "baseline: tip.y";
  moved["status"] = "passed";
  made["verdicts"].push_back(moved);
  return made;
}

std::string observed(double order) {
  WorkPrecision study;
  study.fixed_elements = 4;
  WorkPrecisionRun run;
  run.method.name = "rk4";
  run.method.step = 1e-3;
  study.runs = {run};
  MethodCurve curve;
  curve.label = curve.method = "rk4";
  curve.stated_order = "4";
  curve.elements = 4;
  curve.runs = {0};
  curve.observed.order = order;
  study.curves = {curve};
  return status_of(study_verdicts(study), "order: rk4");
}

/// "1 test, 0 skipped" of a file for a CI page.
std::string tests_in(const std::vector<JunitSuite>& suites) {
  const std::string xml = junit_xml("all", suites);
  return xml.substr(0, xml.find(">", xml.find("<testsuites"))).substr(xml.find(" tests=") + 1);
}

std::string scaled(double value, double limit, Magnitude scale) {
  Verdict verdict;
  verdict.value = value;
  verdict.limit = limit;
  verdict.status = within(value, limit) ? VerdictStatus::passed : VerdictStatus::failed;
  hold_to_scale(verdict, scale, "it");
  return std::string(word(verdict.status));
}

struct Row {
  const char* sentence;
  std::string said, right;
};

const std::vector<Row>& rows() {
  const auto number = [](double value) { return Document::array({{{"from_reference", value}}}); };
  const Document none = Document::array({{{"from_reference", nullptr}}});
  static const std::vector<Row> all{
      {"a distance within its limit is within", within(1, 1) ? "within" : "beyond", "within"},
      {"what is not a number is not within", within(nan, 1) ? "within" : "beyond", "beyond"},
      {"what is infinite is not within infinity", within(inf, inf) ? "within" : "beyond", "beyond"},
      {"what was not found is not within", within(-1, 1) ? "within" : "beyond", "beyond"},
      {"nothing is within a limit that is none", within(0, nan) ? "within" : "beyond", "beyond"},

      {"a distance is judged by what it is a distance from", scaled(0.1, 0.5, {2, 1}), "passed"},
      {"a limit beyond all there is judges nothing", scaled(0.1, 3, {2, 1}), "not run"},
      {"what is beyond even such a limit fails", scaled(4, 3, {2, 1}), "failed"},
      {"what is not a number fails by such a limit", scaled(nan, 3, {2, 1}), "failed"},
      {"an infinite limit judges nothing", scaled(0.1, inf, {2, 1}), "not run"},
      {"where nothing is known of the scale a limit is taken", scaled(0.1, 3, {}), "passed"},

      {"an observed order near the stated one is met", observed(4.01), "passed"},
      {"an order that was not observed has no verdict", observed(-1), "no verdict"},
      {"an observed order that is not a number is not met", observed(nan), "failed"},
      {"an infinite observed order is not met", observed(inf), "failed"},

      {"a file of no tests has one that was skipped", tests_in({}),
       "tests=\"1\" failures=\"0\" skipped=\"1\""},
      {"a file of empty suites has one too", tests_in({{"verification", {}}}),
       "tests=\"1\" failures=\"0\" skipped=\"1\""},
      {"a file of one test has that alone", tests_in({{"verification", {{"a", VerdictStatus::passed, "m"}}}}),
       "tests=\"1\" failures=\"0\" skipped=\"0\""},

      {"of no runs none is said to be accurate rightly", swept("accurate", {}), "not run"},
      {"of no runs none is said to be free of faults", swept("faults", {}), "not run"},
      {"of no runs none is said to be finite", swept("finite", {}), "not run"},
      {"of no runs none is said to end as it may", swept("outcomes", {}), "not run"},
      {"a run that failed ends as it may", swept("outcomes", {sweep_run(Outcome::diverged)}), "passed"},
      {"a run that was not judged does not", swept("outcomes", {sweep_run(Outcome::completed)}), "failed"},
      {"where no run is accurate none is so rightly", swept("accurate", {sweep_run(Outcome::diverged)}),
       "not run"},
      {"an accurate run without a second reference is not so rightly",
       swept("accurate", {sweep_run(Outcome::accurate)}), "failed"},

      {"a motion that is known as long as runs are judged is known", motion_known(2, 2, 2), "passed"},
      {"a motion that is known for less is not", motion_known(1, 2, 2), "failed"},
      {"a motion whose neighbours part at once judges nothing", motion_known(2, 2, 0), "not run"},
      {"a motion that is known at its start alone is not known", motion_known(0, 2, 2), "failed"},
      {"a motion that was not compared is not known", motion_known(-1, 2, 2), "failed"},
      {"a motion whose known time is no number is not known", motion_known(nan, 2, 2), "failed"},
      {"a motion without neighbours must be known to its end", motion_known(1, 2, -1, false), "failed"},
      {"a step at the predicted limit is confirmed", critical(1e-3, 1e-3, 1e-3), "passed"},
      {"a step that was not found confirms nothing", critical(-1, -1, 1e-3), "not run"},
      {"a step that is not a number confirms nothing", critical(nan, nan, 1e-3), "not run"},
      {"an infinite step confirms nothing", critical(inf, inf, 1e-3), "failed"},
      {"an infinite prediction asks for nothing", critical(1e-3, 1e-3, inf), "no verdict"},
      {"a prediction that is not a number asks for nothing", critical(1e-3, 1e-3, nan), "no verdict"},

      {"a certified reference is good", reference_of(1e-10, 1e-6, true), "passed"},
      {"a reference that is not certified is not", reference_of(1e-7, 1e-6, false), "failed"},
      {"a reference that nothing was held against is not judged", reference_of(1e-10, -1, false), "not run"},
      {"a reference that failed is not judged", reference_of(-1, 1e-6, false), "not run"},

      {"a picture within its tolerance holds", picture_error(0.1, true), "passed"},
      {"a picture that no search says to hold does not", picture_error(0.1, false), "failed"},
      {"a picture does not hold against its own number", picture_error(9, true), "failed"},
      {"a picture without an estimate is not judged", picture_error(-1, true), "not run"},
      {"a picture whose error is not a number is not judged", picture_error(nan, true), "not run"},
      {"a picture infinitely far off does not hold", picture_error(inf, true), "failed"},

      {"a run that was left to its scene is not judged without its choice", without_choice(true), "not run"},
      {"a run that was not has no picture error to be judged", without_choice(false), "no verdict"},

      {"a picture of known truth is judged", economical("truth", {}), "passed"},
      {"a picture of unknown truth is not", economical("truth", {.true_error = -1}), "not run"},
      {"a truth that is not a number judges nothing", economical("truth", {.true_error = nan}), "not run"},
      {"a truth that may be off without end judges nothing", economical("truth", {.doubt = inf}), "not run"},
      {"a truth that is not certified judges nothing", economical("truth", {.certified = false}), "not run"},
      {"an infinite true error is beyond the tolerance", economical("truth", {.true_error = inf}), "failed"},
      {"estimates beside truths are judged", economical("estimates", {}), "passed"},
      {"estimates are not judged where there is none", economical("estimates", {.estimate = -1}), "not run"},
      {"estimates are not judged by no truth", economical("estimates", {.true_error = -1}), "not run"},
      {"estimates are not judged beyond an endless doubt", economical("estimates", {.doubt = inf}),
       "not run"},
      {"estimates that are infinite are not judged", economical("estimates", {.estimate = inf}), "not run"},
      {"what costs a thousandth is cheap", economical("cost", {}), "passed"},
      {"what was not timed is not cheap", economical("cost", {.seconds = -1}), "not run"},
      {"what took no time that is a number is not cheap", economical("cost", {.seconds = nan}), "not run"},
      {"nothing is cheap beside what never ended", economical("cost", {.safe = inf}), "not run"},

      {"scenes that are within their tolerance are met", random_scenes({scene(true, 0.5)}), "passed"},
      {"no scenes are not met", random_scenes({}), "no verdict"},
      {"scenes of which none is said to hold are not met", random_scenes({scene(false, -1)}), "not run"},
      {"scenes of unknown truth are not met", random_scenes({scene(true, -1)}), "failed"},
      {"scenes whose truth may be off without end are not met", random_scenes({scene(true, 0.5, inf)}),
       "failed"},

      {"a variant within its margins is as expected", varied({0.5}), "passed"},
      {"a variant of which nothing is expected claims nothing", varied({}), "no verdict"},
      {"a variant whose figure is not a number is not as expected", varied({nan, 0.5}), "failed"},
      {"a variant whose figure is infinite is not as expected", varied({inf}), "failed"},

      {"a budget repeats a series to its distance", budgeted(number(0.01)), "0.01"},
      {"a budget of no series repeats nothing", budgeted(Document::array()), "not compared"},
      {"a budget that found no distance repeats nothing", budgeted(number(-1)), "not compared"},
      {"a budget that failed repeats nothing", budgeted(Document::array(), "diverged"), "diverged"},
      {"a budget whose distance is not a number repeats nothing", budgeted(none), "no finite distance"},

      {"a run with its criterion met is good", concluded(document()), "good"},
      {"a run without criteria is not", concluded(without_verdicts()), "not good"},
      {"what did not move agrees with nothing",
       conclusion_of(named_baseline()).sentence.find("agrees") == std::string::npos ? "nothing" : "agrees",
       "nothing"},
  };
  return all;
}

class SaidGood : public ::testing::TestWithParam<std::size_t> {};

TEST_P(SaidGood, OnlyOfWhatIs) {
  const Row& row = rows()[GetParam()];
  EXPECT_EQ(row.said, row.right) << row.sentence;
}

INSTANTIATE_TEST_SUITE_P(Report, SaidGood, ::testing::Range<std::size_t>(0, rows().size()),
                         [](const auto& row) {
                           std::string name = rows()[row.param].sentence;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

}  // namespace said_good_test
}  // namespace plumb
