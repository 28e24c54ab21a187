#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "engine/base/errors.h"
#include "tests/engine/study/work_precision/tiny_study.h"

namespace plumb {
namespace study_run_test {

namespace fs = std::filesystem;

/// A path for a journal, removed with it.
class JournalPath {
 public:
  JournalPath()
      : path_(
            fs::temp_directory_path() /
            ("plumb-journal-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    fs::remove(path_);
  }
  ~JournalPath() { fs::remove(path_); }
  std::string string() const { return path_.string(); }

 private:
  fs::path path_;
};

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

void write_lines(const std::string& path, const std::vector<std::string>& lines, const std::string& torn) {
  std::ofstream file(path, std::ios::binary);
  for (const std::string& line : lines) file << line << '\n';
  file << torn;
}

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

TEST(StudyRun, FindsErrorsOrdersFrontsAndTheMeshConvergence) {
  StudyJournal journal;
  const WorkPrecision study = run_work_precision(tiny_study_case().spec, false, journal);
  EXPECT_EQ(study.fixed_elements, 2);
  ASSERT_EQ(study.mesh_references.size(), 2U);
  EXPECT_TRUE(study.mesh_references[0].certified) << study.mesh_references[0].why_not;
  EXPECT_EQ(study.converged_reference.elements, 8);
  ASSERT_TRUE(study.mesh.has_value());
  EXPECT_EQ(study.mesh->elements, (std::vector<int>{2, 4, 8}));
  EXPECT_EQ(study.mesh->distance.back(), 0);
  for (const StudyCurve& curve : study.curves) {
    if (curve.elements != 2 || !curve.label.ends_with("fixed step")) continue;
    EXPECT_NEAR(curve.observed.order, 2, 0.3) << curve.label;
  }
  EXPECT_FALSE(study.time_front.empty());
  EXPECT_FALSE(study.time_cheapest.empty());
  for (const StudyRun& run : study.runs) {
    EXPECT_NE(run.outcome, Outcome::not_run);
    EXPECT_GT(run.work_seconds(), 0);
    EXPECT_EQ(run.completed(), run.time_error.tip_max >= 0) << run.message;
    EXPECT_EQ(run.completed(), run.message.empty()) << run.message;
    if (run.completed()) {
      // Short runs are repeated four times as often; which are short is for the machine to say.
      EXPECT_TRUE(run.seconds.size() == 8 || run.seconds.size() == 2) << run.seconds.size();
    }
  }
  for (const std::size_t k : study.time_front) EXPECT_EQ(study.runs[k].elements, 2);
}

TEST(StudyRun, RunsThatFailOrRunOutOfTimeAreKeptWithTheirReason) {
  StudyJournal journal;
  LoadedCase loaded = tiny_study_case();
  loaded.spec.work_precision->largest_step = 1e-2;
  const WorkPrecision failing = run_work_precision(loaded.spec, false, journal);
  const StudyRun& coarse = failing.runs[failing.curves[0].runs[0]];
  EXPECT_EQ(coarse.method.name, "rk4");
  EXPECT_TRUE(coarse.outcome == Outcome::unstable || coarse.outcome == Outcome::diverged ||
              coarse.outcome == Outcome::singular)
      << word(coarse.outcome);
  EXPECT_NE(coarse.message.find("rk4 ended at t = "), std::string::npos) << coarse.message;

  StudyJournal another;
  loaded = tiny_study_case();
  loaded.spec.work_precision->full.time_limit = 1e-9;
  const WorkPrecision late = run_work_precision(loaded.spec, false, another);
  const StudyCurve& last = late.curves.back();
  const StudyRun& run = late.runs[last.runs.back()];
  EXPECT_EQ(run.outcome, Outcome::out_of_time);
  EXPECT_NE(run.message.find("the time allowed, 1e-09 s, is over"), std::string::npos) << run.message;
  EXPECT_LT(last.runs.size(), 5U);
  EXPECT_FALSE(last.ending.empty());
  EXPECT_EQ(run.seconds.size(), 1U);
}

TEST(StudyRun, AnInterruptedStudyGoesOnWhereItWasAndComesToTheSameEnd) {
  const JournalPath path;
  const Case spec = tiny_study_case().spec;
  WorkPrecision whole;
  {
    StudyJournal journal(path.string(), "a");
    whole = run_work_precision(spec, false, journal);
  }
  const std::vector<std::string> lines = lines_of(path.string());
  ASSERT_GT(lines.size(), 20U);
  // Cut in the middle of a line, as by a power cut.
  const std::size_t kept = lines.size() / 2;
  write_lines(path.string(), {lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(kept)},
              lines[kept].substr(0, lines[kept].size() / 2));
  StudyJournal journal(path.string(), "a");
  EXPECT_EQ(journal.found(), kept - 1) << "all but the heading and the torn line";
  expect_same(run_work_precision(spec, false, journal), whole);
  const std::vector<std::string> after = lines_of(path.string());
  EXPECT_EQ(after.size(), lines.size()) << "nothing was done twice, nothing left out";
  for (std::size_t k = 0; k < kept; ++k) EXPECT_EQ(after[k], lines[k]);
  journal.remove();
  EXPECT_FALSE(fs::exists(path.string()));
}

TEST(StudyRun, AStudyThatIsDoneIsNotRunAgainAndKeepsItsTimes) {
  const JournalPath path;
  const Case spec = tiny_study_case().spec;
  WorkPrecision first;
  {
    StudyJournal journal(path.string(), "a");
    first = run_work_precision(spec, false, journal);
  }
  const std::size_t lines = lines_of(path.string()).size();
  StudyJournal journal(path.string(), "a");
  const WorkPrecision again = run_work_precision(spec, false, journal);
  EXPECT_EQ(lines_of(path.string()).size(), lines);
  for (std::size_t k = 0; k < first.runs.size(); ++k) EXPECT_EQ(again.runs[k].seconds, first.runs[k].seconds);
}

TEST(StudyJournal, OfAnotherCaseProgramOrMachineIsStartedAnew) {
  const JournalPath path;
  StudyRun run;
  run.method.name = "rk4";
  run.method.step = 0.1;
  run.elements = 3;
  {
    StudyJournal journal(path.string(), "a");
    journal.add_run(run);
  }
  EXPECT_EQ(StudyJournal(path.string(), "a").found(), 1U);
  EXPECT_EQ(StudyJournal(path.string(), "b").found(), 0U);
  EXPECT_EQ(StudyJournal(path.string(), "a").found(), 0U) << "b has taken its place";
  const CaseSource source = tiny_study_case().source;
  CaseSource other = source;
  other.overrides = {"cable.elements=3"};
  EXPECT_NE(study_identity(source, false), study_identity(other, false));
  EXPECT_NE(study_identity(source, false), study_identity(source, true));
  EXPECT_EQ(study_identity(source, false), study_identity(source, false));
}

TEST(StudyJournal, LinesOfNonsenseAreLeftOut) {
  const JournalPath path;
  { StudyJournal journal(path.string(), "a"); }
  std::vector<std::string> lines = lines_of(path.string());
  for (const char* bad :
       {"", "{", "[]", "{\"run\":1}", "00000000 {\"run\":{\"method\":{}}}", "{\"seconds\":\"x\",\"of\":1}",
        "\xff\xfe", "{\"reference\":{\"elements\":\"many\"}}"})
    lines.emplace_back(bad);
  write_lines(path.string(), lines, "");
  const StudyJournal journal(path.string(), "a");
  EXPECT_EQ(journal.found(), 0U);
  EXPECT_EQ(journal.damaged(), 8U);
}

/// Two runs, the second of which is not a number anywhere.
std::vector<StudyRun> two_runs() {
  StudyRun run;
  run.method.name = "rk4";
  run.method.step = 0.1;
  run.elements = 3;
  run.time_error = {1, 2, 3, 4};
  StudyRun other = run;
  other.elements = 4;
  other.time_error = {NAN, INFINITY, NAN, NAN};
  return {run, other};
}

TEST(StudyJournal, ALineThatWasChangedIsNotTrusted) {
  const JournalPath path;
  {
    StudyJournal journal(path.string(), "a");
    for (const StudyRun& run : two_runs()) journal.add_run(run);
  }
  const std::vector<std::string> lines = lines_of(path.string());
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(StudyJournal(path.string(), "a").found(), 2U);
  EXPECT_EQ(StudyJournal(path.string(), "a").damaged(), 0U) << "what is not finite is no damage";
  for (std::size_t at = 0; at < lines[1].size(); at += 3) {
    std::vector<std::string> changed = lines;
    changed[1][at] = static_cast<char>(changed[1][at] ^ 1);
    write_lines(path.string(), changed, "");
    const StudyJournal journal(path.string(), "a");
    EXPECT_EQ(journal.found(), 1U) << "byte " << at << " of " << lines[1];
    EXPECT_EQ(journal.damaged(), 1U);
    EXPECT_FALSE(journal.find_run(two_runs()[0].method, 3)) << "byte " << at;
    EXPECT_TRUE(journal.find_run(two_runs()[0].method, 4));
  }
}

TEST(StudyJournal, ALineOfAnotherJournalDoesNotCount) {
  const JournalPath path;
  std::vector<std::string> lines;
  {
    StudyJournal journal(path.string(), "a");
    journal.add_run(two_runs()[0]);
  }
  lines = lines_of(path.string());
  { StudyJournal journal(path.string(), "b"); }
  write_lines(path.string(), {lines_of(path.string())[0], lines[1]}, "");
  const StudyJournal journal(path.string(), "b");
  EXPECT_EQ(journal.found(), 0U);
  EXPECT_EQ(journal.damaged(), 1U);
}

TEST(StudyJournal, WhatIsNoJournalStaysAsItIs) {
  const JournalPath path;
  const std::string precious = path.string() + "-precious";
  const auto refused = [&](const char* what) {
    EXPECT_THROW(StudyJournal(path.string(), "a"), OutputError) << what;
  };
  write_lines(precious, {"mine"}, "");
  fs::create_symlink(precious, path.string());
  refused("a link");
  EXPECT_EQ(lines_of(precious), std::vector<std::string>{"mine"});
  fs::remove(path.string());
  write_lines(path.string(), {"mine"}, "");
  refused("a text");
  EXPECT_EQ(lines_of(path.string()), std::vector<std::string>{"mine"});
  for (const char* text :
       {R"({"identity":"my own diary","x":1})", R"({"identity":"a","plumb_study_journal":"no"})"}) {
    write_lines(path.string(), {text}, "");
    refused(text);
    EXPECT_EQ(lines_of(path.string()), std::vector<std::string>{text});
  }
  fs::remove(path.string());
  ASSERT_EQ(::mkfifo(path.string().c_str(), 0600), 0);
  refused("a pipe");
  fs::remove(path.string());
  { StudyJournal journal(precious + ".jsonl", "b"); }
  fs::create_hard_link(precious + ".jsonl", path.string());
  refused("another study's under two names");
  EXPECT_EQ(lines_of(path.string()).size(), 1U);
  fs::remove(precious);
  fs::remove(precious + ".jsonl");
}

TEST(StudyJournal, CutOffWithinItsHeadingIsStartedAnew) {
  const JournalPath path;
  for (const char* text : {"", "{", "{\"identity\":\"a"}) {
    write_lines(path.string(), {}, text);
    EXPECT_EQ(StudyJournal(path.string(), "a").found(), 0U) << text;
    EXPECT_EQ(lines_of(path.string()).size(), 1U) << text;
  }
}

TEST(StudyJournal, ThatCannotBeWrittenIsAnOutputError) {
  EXPECT_THROW(StudyJournal("/nowhere/journal", "a"), OutputError);
}

}  // namespace study_run_test
}  // namespace plumb
