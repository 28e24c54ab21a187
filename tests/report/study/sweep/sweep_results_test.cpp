#include "report/study/sweep/sweep_results.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "engine/study/sweep/run_sweep.h"
#include "render/image/png.h"
#include "tests/engine/study/sweep/tiny_sweep.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace sweep_report_test {

using Json = nlohmann::json;

SweepRun made_run(long number, const std::string& method, Outcome outcome) {
  SweepRun run;
  run.number = number;
  run.method = method;
  run.outcome = outcome;
  run.overrides = {"method.name=" + method, "supports.first=free"};
  run.disagreement = 1e-7;
  if (outcome == Outcome::accurate || outcome == Outcome::inaccurate)
    run.error = run.second_error = outcome == Outcome::accurate ? 1e-5 : 0.1;
  else
    run.message = "it <broke>";
  return run;
}

/// Four runs of two methods, none of them wrong.
Sweep made_sweep() {
  Sweep sweep;
  sweep.loaded = tiny_sweep_case({"cable.density=8000 / f^2", "study.sweep.cases=4"});
  sweep.spec = sweep_of(sweep.loaded.spec);
  sweep.runs = {made_run(0, "rk4", Outcome::accurate), made_run(1, "rk4", Outcome::unstable),
                made_run(2, "gauss", Outcome::accurate), made_run(3, "rk4", Outcome::inaccurate)};
  return sweep;
}

std::vector<VerdictStatus> statuses(const Sweep& sweep) {
  std::vector<VerdictStatus> result;
  for (const Verdict& verdict : sweep_verdicts(sweep)) result.push_back(verdict.status);
  return result;
}

constexpr VerdictStatus passed = VerdictStatus::passed, failed = VerdictStatus::failed;

TEST(SweepReport, SaysWhatNoneOfTheCasesDoes) {
  const Sweep sweep = made_sweep();
  EXPECT_EQ(statuses(sweep), (std::vector{passed, passed, passed, passed}));
  EXPECT_EQ(evaluate_sweep(sweep, {}).headline,
            "Every run tells the truth: of 4 runs of 1 random model none ends accurate beyond its tolerance, "
            "crashes, hangs "
            "or holds a number that is not finite; with 95 % confidence less than 95 % of such models have "
            "one that does.");
  EXPECT_EQ(evaluate_sweep(sweep, {}).counts, "4 of 4 criteria met.");
  for (const SweepRun& run : sweep.runs) EXPECT_EQ(trouble_of(run, sweep.spec.tolerance), "");
}

TEST(SweepReport, OneRunThatIsWronglyAccurateFailsIt) {
  Sweep sweep = made_sweep();
  sweep.runs[2].second_error = 1.5e-3;
  EXPECT_EQ(statuses(sweep), (std::vector{failed, passed, passed, passed}));
  EXPECT_NE(evaluate_sweep(sweep, {}).headline.find("1 ends accurate beyond its tolerance"),
            std::string::npos)
      << evaluate_sweep(sweep, {}).headline;
  EXPECT_EQ(trouble_of(sweep.runs[2], 1e-3), "accurate with 1e-05 m, but 0.0015 m from the second reference");
}

TEST(SweepReport, OneCrashOneNumberOrOneUnjudgedRunFailsIt) {
  Sweep sweep = made_sweep();
  sweep.runs[1].fault = "crashed (signal 11)";
  EXPECT_EQ(statuses(sweep), (std::vector{passed, failed, passed, passed}));
  sweep = made_sweep();
  sweep.runs[1].finite = false;
  EXPECT_EQ(statuses(sweep), (std::vector{passed, passed, failed, passed}));
  for (const Outcome outcome : {Outcome::completed, Outcome::not_run}) {
    sweep = made_sweep();
    sweep.runs[1].outcome = outcome;
    EXPECT_EQ(statuses(sweep), (std::vector{passed, passed, passed, failed}));
  }
}

TEST(SweepReport, ASweepWithoutAnAccurateRunShowsNothingOfThem) {
  Sweep sweep = made_sweep();
  for (SweepRun& run : sweep.runs)
    if (run.outcome == Outcome::accurate) run.outcome = Outcome::inaccurate;
  EXPECT_EQ(statuses(sweep), (std::vector{VerdictStatus::not_run, passed, passed, passed}));
}

TEST(SweepReport, SharesAreOfAllAndOfEachMethod) {
  const Sweep sweep = made_sweep();
  EXPECT_EQ(outcome_counts(sweep),
            (OutcomeCounts{{Outcome::accurate, 2}, {Outcome::inaccurate, 1}, {Outcome::unstable, 1}}));
  const auto by_method = outcome_counts_by_method(sweep);
  ASSERT_EQ(by_method.size(), 2U);
  EXPECT_EQ(by_method[0].first, "rk4");
  EXPECT_EQ(by_method[1].second, (OutcomeCounts{{Outcome::accurate, 1}}));
  const Json json = content_of(evaluate_sweep(sweep, {})).document;
  EXPECT_EQ(json["sweep"]["outcomes"]["accurate"]["share"], 0.5);
  EXPECT_EQ(json["sweep"]["methods"]["rk4"]["unstable"]["runs"], 1);
  EXPECT_EQ(json["sweep"]["runs"].size(), 4U);
  EXPECT_EQ(json["sweep"]["seed"], 1);
  EXPECT_EQ(json["all_criteria_met"], true);
  double bars = 0;
  const std::vector<Figure> figures = sweep_figures(sweep);
  for (const Bar& bar : figures[0].plot.panels[0].bars) bars += bar.x[1] - bar.x[0];
  EXPECT_NEAR(bars, 300, 1e-9) << "each of three rows is 100 % long";
}

TEST(SweepReport, PageNamesWhatIsWrongWithItsCommand) {
  Sweep sweep = made_sweep();
  const std::string clean = to_page(evaluate_sweep(sweep, {}), shown_sweep(sweep, {}));
  EXPECT_EQ(clean.find("{{"), std::string::npos);
  EXPECT_EQ(clean.find("<script"), std::string::npos);
  EXPECT_EQ(clean.find("it <broke>"), std::string::npos);
  EXPECT_NE(clean.find("it &lt;broke&gt;"), std::string::npos);
  EXPECT_NE(clean.find("Nothing: no run ends accurate beyond its tolerance"), std::string::npos);
  sweep.runs[3].fault = "hung: nothing for 60 s";
  const std::string command =
      "plumb solve tiny.toml --set 'cable.density=8000 / f^2' --set study.sweep.cases=4 --set "
      "method.name=rk4 --set supports.first=free";
  EXPECT_EQ(command_of(sweep, sweep.runs[3]), command);
  const std::string page = to_page(evaluate_sweep(sweep, {}), shown_sweep(sweep, {}));
  EXPECT_NE(page.find("hung: nothing for 60 s"), std::string::npos);
  EXPECT_NE(page.find("<strong>1 run:</strong>"), std::string::npos);
  const std::string summary = content_of(evaluate_sweep(sweep, {})).summary;
  EXPECT_NE(summary.find(command), std::string::npos) << summary;
  EXPECT_NE(report_formats()[1].text(content_of(evaluate_sweep(sweep, {}))).find("failures=\"1\""),
            std::string::npos);
}

TEST(SweepReport, SummaryStaysBelowItsSizeHoweverMuchIsWrong) {
  Sweep sweep = made_sweep();
  sweep.runs.resize(3000, sweep.runs[1]);
  for (SweepRun& run : sweep.runs) run.fault = "crashed (signal 11)";
  EXPECT_LT(content_of(evaluate_sweep(sweep, {})).summary.size(), 64U * 1024);
}

TEST(SweepProgram, StudyMakesItsFolderAndReportSaysTheSameAgain) {
  const TemporaryFolder folder;
  const std::string file = case_path("failure/random_sweep.toml");
  ASSERT_EQ(plumb_in(folder.path(), {"check", file}).status, 0);
  const Ended ended = plumb_in(folder.path(), {"study", file, "--set", "study.sweep.cases=24", "--set",
                                               "study.sweep.time_limit=0.1", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err << ended.out;
  for (const char* name :
       {"index.html", "results.json", "junit.xml", "summary.md", "study.json", "figures/sweep_outcomes.png"})
    EXPECT_TRUE(fs::exists(folder / "output/random_sweep_sweep" / name)) << name;
  EXPECT_TRUE(text_in_png(read_text(folder / "output/random_sweep_sweep/figures/sweep_outcomes.png"),
                          renderer_keyword, "figure"));
  EXPECT_NE(ended.err.find("of 24 runs of 3 random models none ends"), std::string::npos) << ended.err;
  Json first = Json::parse(ended.out);
  const Ended again = plumb_in(folder.path(), {"report", "output/random_sweep_sweep", "-o", "b", "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  Json second = Json::parse(again.out);
  first.erase("seconds");
  second.erase("seconds");
  EXPECT_EQ(first, second);
}

TEST(SweepProgram, AnyCaseCanBeSweptByName) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), {"study", case_path("pendulum.toml"), "sweep", "--set",
                                               "study.sweep.cases=8", "--set", "study.sweep.time_limit=0.1"});
  EXPECT_EQ(ended.status, 0) << ended.err << ended.out;
  EXPECT_TRUE(fs::exists(folder / "output/pendulum_sweep/index.html"));
}

TEST(SweepProgram, InterruptedItEndsWith130AndLeavesNoProcessBehind) {
  const TemporaryFolder folder;
  const pid_t child = start({PLUMB_PROGRAM, "study", case_path("failure/random_sweep.toml"), "--set",
                             "study.sweep.cases=100000", "-o", "a"},
                            folder.path());
  const auto of_child = [&] { return read_text(fmt::format("/proc/{0}/task/{0}/children", child)); };
  std::string workers;
  while (workers.empty() && ::kill(child, 0) == 0) workers = of_child();
  ::kill(child, SIGINT);
  const Ended ended = finish(child, folder.path());
  EXPECT_EQ(ended.status, 130) << ended.err;
  EXPECT_FALSE(fs::exists(folder / "a"));
  std::istringstream list(workers);
  for (pid_t worker = 0; list >> worker;) EXPECT_NE(::kill(worker, 0), 0) << "process " << worker;
}

TEST(SweepProgram, ADamagedStudyIsRefusedInOneLine) {
  const TemporaryFolder folder;
  write_text(folder / "a/study.json", "{\"kind\": \"sweep\", \"version\": 1}");
  const Ended ended = plumb_in(folder.path(), {"report", "a"});
  EXPECT_EQ(ended.status, 3);
  expect_one_line(ended.err);
}

}  // namespace sweep_report_test
}  // namespace plumb
