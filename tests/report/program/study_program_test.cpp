#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/report/program/program.h"

namespace plumb {
namespace study_program_test {

using Json = nlohmann::json;

std::vector<std::string> study_command(const std::vector<std::string>& more = {}) {
  std::vector<std::string> command{"study", case_path("pendulum.toml")};
  for (const char* setting :
       {"time.end=0.05", "time.output_interval=0.01", "cable.elements=2",
        "study.work_precision.elements=[2,4]", "study.work_precision.methods=[\"rk4\",\"generalized-alpha\"]",
        "study.work_precision.points=4", "study.work_precision.smallest_step=1e-4",
        "study.work_precision.repeats=1"}) {
    command.emplace_back("--set");
    command.emplace_back(setting);
  }
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

TEST(StudyProgram, StudyMakesItsFolderAndSaysTheCheapestOfEachDecade) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), study_command());
  EXPECT_TRUE(ended.status == 0 || ended.status == 1) << ended.err << ended.out;
  for (const char* file : {"study.h5", "results.json", "junit.xml", "summary.md"})
    EXPECT_TRUE(fs::exists(folder / "output/pendulum_study" / file)) << file;
  EXPECT_FALSE(fs::exists(folder / "output/pendulum_study.unfinished.jsonl"));
  EXPECT_NE(ended.out.find("below 1e-3 m: "), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("Observed orders"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("Pareto front"), std::string::npos) << ended.out;
  const std::string conclusion = Json::parse(read_text(folder / "output/pendulum_study/results.json"))
                                     .at("work_precision")
                                     .at("conclusion")
                                     .at("in_words");
  EXPECT_NE(ended.out.find(conclusion.substr(0, conclusion.find(": "))), std::string::npos) << conclusion;
  const std::string page = read_text(folder / "output/pendulum_study/index.html");
  EXPECT_NE(page.find("<source media=\"screen and (prefers-color-scheme: dark)\""), std::string::npos)
      << "figures suit a dark page";
}

TEST(StudyProgram, JsonIsWhatResultsHold) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), study_command({"--json", "-o", "a"}));
  const Json json = Json::parse(ended.out);
  EXPECT_EQ(json, Json::parse(read_text(folder / "a/results.json")));
  EXPECT_EQ(json["work_precision"]["fixed_elements"], 2);
  EXPECT_EQ(json["all_criteria_met"].get<bool>(), ended.status == 0);
}

TEST(StudyProgram, ReportFromAStudySaysWhatTheStudySaid) {
  const TemporaryFolder folder;
  plumb_in(folder.path(), study_command({"-o", "a"}));
  const Ended ended = plumb_in(folder.path(), {"report", "a", "-o", "b"});
  EXPECT_TRUE(ended.status == 0 || ended.status == 1) << ended.err;
  Json a = Json::parse(read_text(folder / "a/results.json")),
       b = Json::parse(read_text(folder / "b/results.json"));
  a.erase("seconds");
  b.erase("seconds");
  EXPECT_EQ(a, b);
  EXPECT_EQ(plumb_in(folder.path(), study_command({"-o", "b"})).status, ended.status)
      << "a study may replace a study";
}

TEST(StudyProgram, KilledItGoesOnWhereItWas) {
  const TemporaryFolder folder;
  std::vector<std::string> command = study_command({"-o", "a", "--set", "study.work_precision.repeats=5"});
  command.insert(command.begin(), PLUMB_PROGRAM);
  const fs::path journal = folder / "a.unfinished.jsonl";
  const auto lines = [&] {
    const std::string text = read_text(journal);
    return std::count(text.begin(), text.end(), '\n');
  };
  const pid_t child = start(command, folder.path());
  for (int k = 0; k < 1000 && lines() < 5; ++k) std::this_thread::yield();
  while (lines() < 5 && ::waitpid(child, nullptr, WNOHANG) == 0) std::this_thread::yield();
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::exists(journal)) << "the study ended before it could be killed";
  EXPECT_FALSE(fs::exists(folder / "a"));
  const Ended ended = run_command(command, folder.path());
  EXPECT_TRUE(ended.status == 0 || ended.status == 1) << ended.err;
  EXPECT_NE(ended.out.find("going on with what "), std::string::npos) << ended.out;
  EXPECT_FALSE(fs::exists(journal));
}

TEST(StudyProgram, InterruptedItEndsWith130AndSaysWhereItsRunsAre) {
  const TemporaryFolder folder;
  std::vector<std::string> command = study_command({"-o", "a", "--set", "study.work_precision.repeats=50"});
  command.insert(command.begin(), PLUMB_PROGRAM);
  const pid_t child = start(command, folder.path());
  siginfo_t ended_already{};
  while (read_text(folder / "a.unfinished.jsonl").size() < 500 && ended_already.si_pid == 0)
    ::waitid(P_PID, static_cast<id_t>(child), &ended_already, WEXITED | WNOHANG | WNOWAIT);
  ::kill(child, SIGINT);
  const Ended ended = finish(child, folder.path());
  EXPECT_EQ(ended.status, 130) << ended.err;
  EXPECT_NE(ended.err.find("a.unfinished.jsonl; the same command goes on from there"), std::string::npos)
      << ended.err;
}

TEST(StudyProgram, WhereNothingCompletesItEndsWithFour) {
  const TemporaryFolder folder;
  const Ended ended =
      plumb_in(folder.path(), study_command({"--set", "study.work_precision.time_limit=1e-9", "--set",
                                             "study.work_precision.largest_step=5e-4", "--set",
                                             "study.work_precision.methods=[\"rk4\"]"}));
  EXPECT_EQ(ended.status, 4) << ended.err << ended.out;
}

TEST(StudyProgram, RunKeepsItsQuickStudyAndReportShowsItAgain) {
  const TemporaryFolder folder;
  std::vector<std::string> command = study_command({"-o", "a", "--set", "scene.size=[160,90]", "--set",
                                                    "study.work_precision.quick.elements=[2]", "--set",
                                                    "study.work_precision.quick.methods=[\"rk4\"]"});
  command[0] = "run";
  const Ended ended = plumb_in(folder.path(), command);
  EXPECT_TRUE(fs::exists(folder / "a/study.h5")) << ended.err;
  const Json ran = Json::parse(read_text(folder / "a/results.json"));
  EXPECT_TRUE(ran["work_precision"]["quick"].get<bool>());
  EXPECT_FALSE(ran["work_precision"]["runs"].empty());
  plumb_in(folder.path(), {"render", "a"});
  EXPECT_TRUE(fs::exists(folder / "a/study.h5")) << "drawing anew keeps it";
  plumb_in(folder.path(), {"report", "a", "-o", "b"});
  EXPECT_EQ(Json::parse(read_text(folder / "b/results.json"))["work_precision"], ran["work_precision"]);
}

}  // namespace study_program_test
}  // namespace plumb
