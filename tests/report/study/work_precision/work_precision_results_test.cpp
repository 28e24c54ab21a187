#include "report/study/work_precision/work_precision_results.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/engine/study/work_precision/tiny_study.h"

namespace plumb {
namespace study_results_test {

/// A made study: one curve of three runs, the last of which failed.
Study made_study() {
  Study study{tiny_study_case(), {}};
  WorkPrecision& result = study.result;
  study.loaded.spec.title = "Made <b>";
  result.fixed_elements = 2;
  result.end = 1;
  result.length = 1;
  MethodCurve& curve = result.curves.emplace_back();
  curve.label = curve.method = "rk4";
  curve.elements = 2;
  curve.stated_order = "4";
  for (const double step : {1e-2, 5e-3, 2.5e-3, 1.25e-3}) {
    WorkPrecisionRun& run = result.runs.emplace_back();
    run.method.name = "rk4";
    run.method.step = step;
    run.elements = 2;
    run.outcome = Outcome::completed;
    run.counters.steps = std::lround(1 / step);
    run.seconds = {1e-3 / step};
    run.time_error.tip_max = run.total_error.tip_max = 1e5 * step * step * step * step;
    curve.runs.push_back(result.runs.size() - 1);
  }
  result.runs.back().outcome = Outcome::out_of_time;
  result.runs.back().message = "too slow";
  result.runs.back().time_error = result.runs.back().total_error = {};
  result.mesh_references.emplace_back().elements = 2;
  result.mesh_references[0].agreement = 1e-9;
  result.converged_reference.elements = 8;
  result.converged_reference.agreement = 1e-9;
  result.converged_mesh_error = 1e-7;
  return study;
}

const Verdict& verdict_named(const std::vector<Verdict>& verdicts, const std::string& name) {
  for (const Verdict& verdict : verdicts)
    if (verdict.name == name) return verdict;
  throw std::out_of_range("no verdict is named " + name);
}

// 1e5 · (1e-2)^4 is 1e-3 m: three runs fall with order 4.
TEST(StudyResults, AnOrderIsHeldAgainstTheStatedOneFromBothSides) {
  for (const auto& [stated, passes] :
       {std::pair{"4", true}, {"3.8", true}, {"4.2", true}, {"3", false}, {"5", false}}) {
    Study study = made_study();
    study.result.curves[0].stated_order = stated;
    evaluate(study.result);
    const Verdict verdict = verdict_named(study_verdicts(study.result), "order: rk4");
    EXPECT_EQ(verdict.status, passes ? VerdictStatus::passed : VerdictStatus::failed) << verdict.message;
    EXPECT_EQ(verdict.kind, VerdictKind::verification);
    EXPECT_NE(verdict.message.find("steps from 0.01 to 0.0025 s"), std::string::npos) << verdict.message;
  }
}

// The made runs show order 4 with steps from 1e-2 to 2.5e-3 s.
TEST(StudyResults, OnlyStiffStepsOfImplicitStagesMayShowAReducedOrder) {
  struct Example {
    const char* method;
    const char* stated;
    double frequency;  // rad/s
    bool reduced, passes;
  };
  for (const Example& example : {Example{"arkode-dirk", "5", 401, true, true},
                                 {"arkode-dirk", "5", 399, false, false},
                                 {"arkode-dirk", "3", 401, true, false},
                                 {"gauss", "6", 401, true, true},
                                 {"rk4", "5", 401, false, false},
                                 {"unknown", "5", 401, false, false}}) {
    Study study = made_study();
    MethodCurve& curve = study.result.curves[0];
    curve.method = example.method;
    curve.stated_order = example.stated;
    study.result.fastest_frequency = example.frequency;
    evaluate(study.result);
    const Verdict verdict = verdict_named(study_verdicts(study.result), "order: rk4");
    EXPECT_EQ(verdict.status, example.passes ? VerdictStatus::passed : VerdictStatus::failed)
        << example.method << ", order " << example.stated << ", " << example.frequency
        << " rad/s: " << verdict.message;
    EXPECT_EQ(verdict.message.find("stage order") != std::string::npos, example.reduced) << verdict.message;
    EXPECT_NE(verdict.criterion.starts_with("|observed"), example.reduced) << verdict.criterion;
  }
}

TEST(StudyResults, NoOrderIsJudgedWhereNoneIsStatedOrSeen) {
  Study study = made_study();
  study.result.curves[0].stated_order = "1 to 5";
  evaluate(study.result);
  EXPECT_THROW(verdict_named(study_verdicts(study.result), "order: rk4"), std::out_of_range);
  study = made_study();
  study.result.runs[1].outcome = Outcome::unstable;
  evaluate(study.result);
  EXPECT_THROW(verdict_named(study_verdicts(study.result), "order: rk4"), std::out_of_range);
}

TEST(StudyResults, AReferenceThatIsNotCertifiedFailsAndSaysItsFloor) {
  Study study = made_study();
  evaluate(study.result);
  EXPECT_EQ(verdict_named(study_verdicts(study.result), "reference: 2 elements").status,
            VerdictStatus::passed);
  study.result.mesh_references[0].agreement = 1e-5;
  evaluate(study.result);
  const Verdict verdict = verdict_named(study_verdicts(study.result), "reference: 2 elements");
  EXPECT_EQ(verdict.status, VerdictStatus::failed);
  EXPECT_NE(verdict.message.find("errors below 0.0001 m mean nothing"), std::string::npos) << verdict.message;
  study.result.mesh_references[0].agreement = -1;
  evaluate(study.result);
  EXPECT_EQ(verdict_named(study_verdicts(study.result), "reference: 2 elements").status,
            VerdictStatus::not_run);
}

TEST(StudyResults, JsonJunitAndSummarySayTheSame) {
  Study study = made_study();
  evaluate(study.result);
  const StudyReport results = evaluate_study(study, {});
  const auto json = content_of(results).document;
  const auto& part = json["work_precision"];
  EXPECT_EQ(part["runs"].size(), 4U);
  EXPECT_EQ(part["runs"][3]["outcome"], "out-of-time");
  EXPECT_EQ(part["runs"][3]["message"], "too slow");
  EXPECT_EQ(part["time_front"], (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(json["all_criteria_met"].get<bool>()) << json["verdicts"];
  EXPECT_NE(json["headline"].get<std::string>().find("1 out-of-time"), std::string::npos) << json["headline"];
  const std::string summary = content_of(results).summary;
  EXPECT_NE(summary.find("below 1e-3 m: rk4 with 2 elements"), std::string::npos) << summary;
  EXPECT_EQ(summary.find("<b>"), std::string::npos);
  EXPECT_LT(summary.size(), 64U * 1024);
  const std::string junit = report_formats()[1].text(content_of(results));
  EXPECT_NE(junit.find("failures=\"0\""), std::string::npos) << junit;
  EXPECT_EQ(junit.find("<b>"), std::string::npos);
}

}  // namespace study_results_test
}  // namespace plumb
