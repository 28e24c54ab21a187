#include "report/study/stability/stability_results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/report/study/stability/made_stability.h"

namespace plumb {
namespace stability_results_test {

const Verdict& verdict_named(const std::vector<Verdict>& verdicts, const std::string& name) {
  for (const Verdict& verdict : verdicts)
    if (verdict.name == name) return verdict;
  throw std::out_of_range("no verdict is named " + name);
}

TEST(StabilityResults, ACriticalStepIsHeldAgainstThePredictedOneFromBothSides) {
  for (const auto& [predicted, passes] :
       {std::pair{1.005e-3, true}, {1.05e-3, true}, {0.96e-3, true}, {1.07e-3, false}, {0.95e-3, false}}) {
    Stability study = made_stability();
    study.critical_steps[1].predicted.at_worst = predicted;
    const std::vector<Verdict> verdicts = stability_verdicts(study);
    const Verdict& verdict = verdict_named(verdicts, "critical step: rk4, f = 5, 4 elements");
    EXPECT_EQ(verdict.status, passes ? VerdictStatus::passed : VerdictStatus::failed) << verdict.message;
    EXPECT_EQ(verdict.kind, VerdictKind::verification);
    EXPECT_NEAR(verdict.value, std::abs(1.005e-3 / predicted - 1), 1e-4);
  }
}

TEST(StabilityResults, AStepThatWasNotFoundIsNotRun) {
  Stability study = made_stability();
  study.critical_steps[0].stable = -1;
  const std::vector<Verdict> verdicts = stability_verdicts(study);
  const Verdict& verdict = verdict_named(verdicts, "critical step: rk4, f = 1, 4 elements");
  EXPECT_EQ(verdict.status, VerdictStatus::not_run);
  EXPECT_EQ(verdict.message, "no stable step was found");
}

TEST(StabilityResults, WithoutAPredictionNothingIsClaimed) {
  Stability study = made_stability();
  study.critical_steps[0].limit_kind = LimitKind::contraction;
  study.critical_steps[1].predicted = {INFINITY, INFINITY};
  for (const Verdict& verdict : stability_verdicts(study))
    EXPECT_TRUE(verdict.name.starts_with("reference: ")) << verdict.name;
}

TEST(StabilityResults, AReferenceMustBeKnownAsLongAsRunsAreJudgedByIt) {
  Stability study = made_stability();
  study.references[0].trusted_until = 1.8;  // its neighbours part at 1.75 s
  study.references[1].trusted_until = 1.8;  // its runs are judged until 2 s
  const std::vector<Verdict> verdicts = stability_verdicts(study);
  EXPECT_EQ(verdict_named(verdicts, "reference: f = 1, 4 elements, 2 s").status, VerdictStatus::passed);
  EXPECT_EQ(verdict_named(verdicts, "reference: f = 5, 4 elements, 2 s").status, VerdictStatus::failed);
}

TEST(StabilityResults, JsonJunitAndSummarySayTheSame) {
  StabilityStudyFile file = made_stability_file();
  file.loaded.spec.title = "Made <b>";
  const StudyReport results = evaluate_stability(file, {});
  const auto json = content_of(results).document;
  EXPECT_TRUE(json["all_criteria_met"].get<bool>()) << json["verdicts"];
  EXPECT_EQ(json["stability"]["maps"].size(), 6U);
  EXPECT_EQ(json["stability"]["maps"][0]["points"][2]["outcome"], "unstable");
  EXPECT_EQ(json["stability"]["maps"][0]["points"][2]["message"], "it ended so");
  EXPECT_EQ(
      results.headline,
      "At f = 5, 4 elements, 2 s: rk4, the only method, stays accurate to 0.01 m up to a step of 1.0e-4 s.");
  EXPECT_EQ(
      results.details,
      "It fails at 4.0e-4 s (unstable). The 2 critical steps found "
      "are within 1.5 % of the ones predicted. Of those that choose their steps, cvode-bdf (order ≤ 2), the "
      "only method, stays accurate to 0.01 m up to rtol 1.0e-4.");
  EXPECT_EQ(
      results.counts,
      "96 points in 6 maps: 12 accurate, 12 inaccurate, 12 unstable, 12 diverged, 12 no-convergence, 12 "
      "singular, 12 unstable-equilibrium, 12 out-of-time. 4 of 4 criteria met.");
  EXPECT_EQ(json["headline"], results.headline + " " + results.details + " " + results.counts);
  EXPECT_EQ(json["stability"]["conclusion"]["in_words"], results.headline + " " + results.details);
  EXPECT_EQ(json["stability"]["conclusion"]["methods"].size(), 2U);
  const std::string junit = report_formats()[1].text(content_of(results)),
                    summary = content_of(results).summary;
  EXPECT_NE(junit.find("failures=\"0\""), junit.npos);
  EXPECT_EQ(junit.find("<b>"), junit.npos);
  EXPECT_EQ(summary.find("<b>"), summary.npos);
  EXPECT_NE(summary.find("- rk4: accurate up to a step of"), summary.npos) << summary;
  EXPECT_LT(summary.size(), 64U * 1024);
}

TEST(StabilityResults, ASummaryOfVeryManyMapsStaysShort) {
  StabilityStudyFile file = made_stability_file();
  for (int k = 0; k < 2000; ++k) file.result.maps.push_back(file.result.maps[1]);
  for (int k = 0; k < 2000; ++k) file.result.critical_steps.push_back(file.result.critical_steps[0]);
  EXPECT_LT(content_of(evaluate_stability(file, {})).summary.size(), 64U * 1024);
}

}  // namespace stability_results_test
}  // namespace plumb
