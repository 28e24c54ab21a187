#include "report/study/work_precision/work_precision_conclusion.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/study/work_precision/work_precision_page.h"
#include "report/study/work_precision/work_precision_results.h"
#include "tests/report/study/work_precision/made_study.h"

namespace plumb {
namespace work_precision_conclusion_test {

/// Three methods of exact orders on four elements, which are 0.016 m off, each in a run with 0.01 s and
/// finer.
MadeCurves three_methods() {
  MadeCurves made;
  made.curve("first", MethodFamily::structural, 4, 1, 1, 1e-7);
  made.curve("second, α = 1, fixed step", MethodFamily::explicit_one_step, 4, 2, 10, 2e-7);
  made.curve("fourth", MethodFamily::explicit_one_step, 4, 4, 100, 4e-7);
  return made;
}

/// The same judged again after a change.
template <class Change>
WorkPrecision changed(const Change& change, WorkPrecision study = three_methods().judged()) {
  change(study);
  evaluate(study);
  return study;
}

void expect_in(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), text.npos) << part << "\nis not in\n" << text;
}

// With 0.01 s the errors are 1e-2, 1e-3 and 1e-6 m; the first needs 1.25e-3 s for a tenth of 0.016 m.
TEST(WorkPrecisionConclusion, NamesTheCheapestRunThatErrsByATenthOfItsMesh) {
  const WorkPrecision study = three_methods().judged();
  EXPECT_EQ(
      conclude(study).sentence,
      "On the 4 elements of the case the cheapest, second (α = 1), needs a step of at most 0.01 s, 20 µs: "
      "the mesh itself is 0.016 m off, and a finer step gains nothing.");
  const WorkPrecision finer = changed([](WorkPrecision& any) { any.mesh->distance[0] = 2e-5; });
  expect_in(conclude(finer).sentence, {"the cheapest, fourth, needs a step of at most 0.01 s, 40 µs"});
}

TEST(WorkPrecisionConclusion, OfEachMeshSaysWhereItTakesOver) {
  const WorkPrecision study = made_study();
  const WorkPrecisionConclusion all = conclude(study);
  ASSERT_EQ(all.meshes.size(), 2U);
  EXPECT_EQ(all.meshes[0].elements, 4);
  EXPECT_DOUBLE_EQ(all.meshes[1].error, 0.004);
  ASSERT_TRUE(all.meshes[1].run);
  const WorkPrecisionRun& run = study.runs[*all.meshes[1].run];
  EXPECT_EQ(run.elements, 8);
  EXPECT_LE(run.time_error.tip_max, share_of_mesh_error * 0.004);
  for (const WorkPrecisionRun& other : study.runs) {
    const bool fine = other.elements == 8 && other.completed() && other.time_error.tip_max <= 4e-4;
    if (fine) {
      EXPECT_GE(other.work_seconds(), run.work_seconds());
    }
  }
}

TEST(WorkPrecisionConclusion, ListsEachWayToTheContinuumOnceWithTheSmallestErrorItStaysBelow) {
  const WorkPrecision study = made_study();
  const WorkPrecisionConclusion all = conclude(study);
  EXPECT_FALSE(all.of_time_alone);
  ASSERT_EQ(all.ways.size(), 2U);
  EXPECT_DOUBLE_EQ(all.ways[0].error, 0.1);
  EXPECT_DOUBLE_EQ(all.ways[1].error, 0.01);
  EXPECT_EQ(study.runs[all.ways[1].run].elements, 8) << "four elements are 0.016 m off";
  expect_in(all.details,
            {"Within 1e-2 m of the continuum, and no run comes within a tenth of that, the cheapest",
             "takes 8 elements"});
}

TEST(WorkPrecisionConclusion, OfManyWaysKeepsTheFirstAndTheLast) {
  WorkPrecision study = three_methods().judged();
  study.total_cheapest.clear();
  for (std::size_t k = 0; k < 12; ++k)
    study.total_cheapest.push_back({std::pow(10.0, -1.0 - static_cast<double>(k)), k, ""});
  const WorkPrecisionConclusion all = conclude(study);
  ASSERT_EQ(all.ways.size(), 5U);
  EXPECT_EQ(all.ways.front().run, 0U);
  EXPECT_EQ(all.ways.back().run, 11U);
}

TEST(WorkPrecisionConclusion, OfOneMethodSaysThatThereIsNoOther) {
  MadeCurves made;
  made.curve("second", MethodFamily::explicit_one_step, 4, 2, 10, 2e-7);
  expect_in(conclude(made.judged()).sentence,
            {"On the 4 elements of the case second, the only method, needs"});
}

TEST(WorkPrecisionConclusion, CountsForcesWhereTimesAreNotComparable) {
  const WorkPrecision study = changed([](WorkPrecision& any) {
    for (WorkPrecisionRun& run : any.runs) run.seconds.clear();
  });
  ASSERT_FALSE(study.timed);
  expect_in(conclude(study).sentence, {"a step of at most 0.01 s, 400 force evaluations: the mesh"});
}

TEST(WorkPrecisionConclusion, WhereNoRunIsExactEnoughForTheMeshNamesTheNearest) {
  const WorkPrecision study = changed([](WorkPrecision& any) { any.mesh->distance[0] = 1e-12; });
  expect_in(
      conclude(study).sentence,
      {"itself 1e-12 m off, no run integrates time to a tenth of that: the nearest, fourth, with a step of "
       "at most 0.000625 s is 1.5e-11 m off in 640 µs"});
  EXPECT_FALSE(conclude(study).meshes[0].run);
  EXPECT_EQ(conclusion_json(study)["meshes"][0]["run"], -1);
}

TEST(WorkPrecisionConclusion, ClaimsNothingOfAMeshWhoseErrorIsNotKnown) {
  const WorkPrecision study = changed([](WorkPrecision& any) { any.mesh.reset(); });
  expect_in(conclude(study).sentence, {"how far off the mesh is, is not known"});
  const WorkPrecision alone = changed([](WorkPrecision& any) {
    any.converged_reference = {};
    for (WorkPrecisionRun& run : any.runs) run.total_error = {};
  });
  EXPECT_TRUE(conclude(alone).of_time_alone);
  expect_in(conclude(alone).details, {"How far all is from the continuum is not known."});
}

TEST(WorkPrecisionConclusion, WhereNoneReachesSaysHowFarTheNearestIs) {
  MadeCurves made;
  made.curve("bad", MethodFamily::structural, 4, 1, 1000, 1e-7);
  const WorkPrecision study = made.judged();
  EXPECT_EQ(
      conclude(study).sentence,
      "No run comes within 0.2 m of the exact motion, 10 % of the length, so no method can be named; the "
      "nearest, bad with step 0.000625 s, is 0.625 m off.");
  EXPECT_TRUE(conclude(study).ways.empty());
}

TEST(WorkPrecisionConclusion, WhereEverythingFailedNamesNoMethod) {
  const WorkPrecision study = changed([](WorkPrecision& any) {
    for (WorkPrecisionRun& run : any.runs) {
      run.outcome = Outcome::unstable;
      run.time_error = run.total_error = {};
    }
  });
  EXPECT_EQ(conclude(study).sentence, "Every run failed, so no method can be named.");
  const Study of_case{run_with("made").loaded, study};
  const StudyReport report = evaluate_study(of_case, {});
  EXPECT_FALSE(report.complete);
  expect_in(report.counts, {"15 unstable"});
  EXPECT_EQ(conclude(study).failing.size(), 3U);
}

TEST(WorkPrecisionConclusion, WithoutAReferenceNamesNoMethod) {
  const WorkPrecision study = changed([](WorkPrecision& any) {
    for (WorkPrecisionRun& run : any.runs) run.time_error = run.total_error = {};
  });
  EXPECT_EQ(conclude(study).sentence,
            "No run that completed could be held against a reference, so no method can be named.");
  EXPECT_EQ(conclude(WorkPrecision{}).sentence, "No run was made, so no method can be named.");
}

TEST(WorkPrecisionConclusion, SaysWhichMethodsFailWithTooCoarseASetting) {
  const WorkPrecision study = changed([](WorkPrecision& any) {
    any.runs[0].outcome = Outcome::unstable;     // first: 0.01 s
    any.runs[1].time_error = {1, 1, 1, 1};       // and 0.005 s: half a length off
    any.runs[3].outcome = Outcome::diverged;     // but for one between good ones
    any.runs[5].outcome = Outcome::out_of_time;  // second: slow, which is no failure
    for (std::size_t k = 10; k < 15; ++k) any.runs[k].outcome = Outcome::no_convergence;  // fourth: all
  });
  const WorkPrecisionConclusion all = conclude(study);
  ASSERT_EQ(all.failing.size(), 2U);
  EXPECT_TRUE(all.failing[0].everywhere);
  EXPECT_EQ(all.failing[1].run, 1U);
  expect_in(all.details,
            {"Too coarse a setting fails: fourth at every step (no-convergence) and first from 0.005 s "
             "(stable but wrong)."});
}

TEST(WorkPrecisionConclusion, IsFirstInThePageTheSummaryAndTheResults) {
  const Study study = made_study_of_a_case();
  const StudyReport report = evaluate_study(study, {});
  const WorkPrecisionConclusion all = conclude(study.result);
  const ReportContent content = content_of(report);
  EXPECT_TRUE(content.document["headline"].get<std::string>().starts_with(all.sentence));
  EXPECT_EQ(content.document["work_precision"]["conclusion"]["in_words"], all.sentence + " " + all.details);
  EXPECT_LT(content.summary.find("On the 4 elements of the case"), content.summary.find(" runs of "))
      << content.summary;
  const std::string page = to_page(report, shown_work_precision(study.result, {}));
  const std::size_t said = page.find("On the 4 elements of the case");
  ASSERT_NE(said, page.npos);
  EXPECT_LT(said, page.find(" runs of "));
  EXPECT_LT(page.find("id=\"study-choice\""), page.find("id=\"study-time\""));
}

}  // namespace work_precision_conclusion_test
}  // namespace plumb
