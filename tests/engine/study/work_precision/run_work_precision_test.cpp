#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "engine/base/errors.h"
#include "engine/study/work_precision/timing.h"
#include "tests/engine/study/in_memory.h"
#include "tests/engine/study/journal_file.h"
#include "tests/engine/study/work_precision/tiny_study.h"

namespace plumb {
namespace study_run_test {

namespace fs = std::filesystem;

/// All but the times, which differ from one measurement to the next.
void expect_same(const WorkPrecision& a, const WorkPrecision& b) {
  ASSERT_EQ(a.runs.size(), b.runs.size());
  for (std::size_t k = 0; k < a.runs.size(); ++k) {
    EXPECT_EQ(a.runs[k].method, b.runs[k].method);
    EXPECT_EQ(a.runs[k].outcome, b.runs[k].outcome);
    EXPECT_EQ(a.runs[k].message, b.runs[k].message);
    EXPECT_EQ(a.runs[k].counters.force_evaluations, b.runs[k].counters.force_evaluations);
    for (const ErrorNorm norm : error_norm_list) {
      EXPECT_EQ(value(a.runs[k].time_error, norm), value(b.runs[k].time_error, norm)) << word(norm);
      EXPECT_EQ(value(a.runs[k].total_error, norm), value(b.runs[k].total_error, norm)) << word(norm);
    }
  }
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t k = 0; k < a.curves.size(); ++k) {
    EXPECT_EQ(a.curves[k].observed.order, b.curves[k].observed.order);
    EXPECT_EQ(a.curves[k].ending, b.curves[k].ending);
  }
  EXPECT_EQ(a.converged_mesh_error, b.converged_mesh_error);
  EXPECT_EQ(a.mesh_references[0].agreement, b.mesh_references[0].agreement);
}

WorkPrecision run_with(Journal& journal) {
  Runner runner(journal);
  return run_work_precision(tiny_study_case().spec, false, runner);
}

TEST(WorkPrecisionRun, FindsErrorsOrdersFrontsAndTheMeshConvergence) {
  const WorkPrecision study = run_work_precision(tiny_study_case().spec, false, InMemory());
  EXPECT_EQ(study.fixed_elements, 2);
  ASSERT_EQ(study.mesh_references.size(), 2U);
  EXPECT_TRUE(study.mesh_references[0].certified) << study.mesh_references[0].why_not;
  EXPECT_EQ(study.converged_reference.elements, 8);
  ASSERT_TRUE(study.mesh.has_value());
  EXPECT_EQ(study.mesh->elements, (std::vector<int>{2, 4, 8}));
  EXPECT_EQ(study.mesh->distance.back(), 0);
  for (const MethodCurve& curve : study.curves) {
    if (curve.elements != 2 || !curve.label.ends_with("fixed step")) continue;
    EXPECT_NEAR(curve.observed.order, 2, 0.3) << curve.label;
  }
  EXPECT_FALSE(study.time_front.empty());
  EXPECT_FALSE(study.time_cheapest.empty());
  for (const WorkPrecisionRun& run : study.runs) {
    EXPECT_NE(run.outcome, Outcome::not_run);
    EXPECT_GT(run.work_seconds(), 0);
    EXPECT_EQ(run.completed(), run.time_error.tip_max >= 0) << run.message;
    EXPECT_EQ(run.completed(), run.message.empty()) << run.message;
    if (run.completed()) {
      EXPECT_TRUE(is_timed(run.seconds, 2)) << run.seconds.size();
      const std::vector<double> before(run.seconds.begin(), run.seconds.end() - 1);
      EXPECT_FALSE(is_timed(before, 2)) << "repeated though it was settled";
    }
  }
  for (const std::size_t k : study.time_front) EXPECT_EQ(study.runs[k].elements, 2);
}

TEST(WorkPrecisionRun, RunsThatFailOrRunOutOfTimeAreKeptWithTheirReason) {
  LoadedCase loaded = tiny_study_case();
  loaded.spec.work_precision->largest_step = 1e-2;
  const WorkPrecision failing = run_work_precision(loaded.spec, false, InMemory());
  const WorkPrecisionRun& coarse = failing.runs[failing.curves[0].runs[0]];
  EXPECT_EQ(coarse.method.name, "rk4");
  EXPECT_TRUE(coarse.outcome == Outcome::unstable || coarse.outcome == Outcome::diverged ||
              coarse.outcome == Outcome::singular)
      << word(coarse.outcome);
  EXPECT_NE(coarse.message.find("rk4 ended at t = "), std::string::npos) << coarse.message;

  loaded = tiny_study_case();
  loaded.spec.work_precision->full.time_limit = 1e-9;
  const WorkPrecision late = run_work_precision(loaded.spec, false, InMemory());
  const MethodCurve& last = late.curves.back();
  const WorkPrecisionRun& run = late.runs[last.runs.back()];
  EXPECT_EQ(run.outcome, Outcome::out_of_time);
  EXPECT_NE(run.message.find("the time allowed, 1e-09 s, is over"), std::string::npos) << run.message;
  EXPECT_LT(last.runs.size(), 5U);
  EXPECT_FALSE(last.ending.empty());
  EXPECT_EQ(run.seconds.size(), 1U);
}

TEST(WorkPrecisionRun, AnInterruptedStudyGoesOnWhereItWasAndComesToTheSameEnd) {
  const JournalPath path;
  WorkPrecision whole;
  {
    Journal journal(path.string(), {"a", "case.toml"});
    whole = run_with(journal);
  }
  const std::vector<std::string> lines = lines_of(path.string());
  ASSERT_GT(lines.size(), 20U);
  // Cut in the middle of a line, as by a power cut.
  const std::size_t kept = lines.size() / 2;
  write_lines(path.string(), {lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(kept)},
              lines[kept].substr(0, lines[kept].size() / 2));
  Journal journal(path.string(), {"a", "case.toml"});
  EXPECT_EQ(journal.found(), kept - 2) << "all but the heading, the machine and the torn line";
  expect_same(run_with(journal), whole);
  const std::vector<std::string> after = lines_of(path.string());
  EXPECT_EQ(after.size(), lines.size()) << "nothing was done twice, nothing left out";
  for (std::size_t k = 0; k < kept; ++k) EXPECT_EQ(after[k], lines[k]);
  journal.remove();
  EXPECT_FALSE(fs::exists(path.string()));
}

TEST(WorkPrecisionRun, AStudyThatIsDoneIsNotRunAgainAndKeepsItsTimes) {
  const JournalPath path;
  WorkPrecision first;
  {
    Journal journal(path.string(), {"a", "case.toml"});
    first = run_with(journal);
  }
  const std::size_t lines = lines_of(path.string()).size();
  Journal journal(path.string(), {"a", "case.toml"});
  const WorkPrecision again = run_with(journal);
  EXPECT_EQ(lines_of(path.string()).size(), lines);
  for (std::size_t k = 0; k < first.runs.size(); ++k) EXPECT_EQ(again.runs[k].seconds, first.runs[k].seconds);
}

TEST(WorkPrecisionRun, TakesNothingOverFromAQuickOneThatHadTooLittleTime) {
  LoadedCase loaded = tiny_study_case();
  WorkPrecisionSpec& spec = *loaded.spec.work_precision;
  spec.quick = spec.full;
  spec.quick.time_limit = 1e-9;
  Journal journal;
  Runner runner(journal);
  const WorkPrecision quick = run_work_precision(loaded.spec, true, runner);
  EXPECT_FALSE(quick.converged_reference.certified) << "it had the time that it needs";
  expect_same(run_work_precision(loaded.spec, false, runner),
              run_work_precision(loaded.spec, false, InMemory()));
}

}  // namespace study_run_test
}  // namespace plumb
