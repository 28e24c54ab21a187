#include <csignal>
#include <nlohmann/json.hpp>

#include "render/image/png.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace stability_program_test {

using Json = nlohmann::json;

std::vector<std::string> stability_command(const std::vector<std::string>& more = {}) {
  std::vector<std::string> command{"study", case_path("pendulum.toml"), "stability"};
  for (const char* setting :
       {"time.end=0.05", "time.output_interval=0.01", "cable.elements=2", "study.stability.elements=[2,4]",
        "study.stability.parameter_values=[5,20]", "study.stability.durations=[0.05,0.1]",
        "study.stability.methods=[\"rk4\",\"trapezoidal\"]", "study.stability.steps=4",
        "study.stability.largest_step=0.01", "study.stability.smallest_step=5e-4",
        "study.stability.tightest_tolerance=1e-5", "study.stability.limit_methods=[\"rk4\"]"}) {
    command.emplace_back("--set");
    command.emplace_back(setting);
  }
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

TEST(StabilityProgram, StudyMakesItsFolderAndSaysTheSteps) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), stability_command());
  EXPECT_TRUE(ended.status == 0 || ended.status == 1) << ended.err << ended.out;
  for (const char* file : {"study.json", "index.html", "results.json", "junit.xml", "summary.md",
                           "figures/stability_parameter.png", "figures/stability_rk4.png"})
    EXPECT_TRUE(fs::exists(folder / "output/pendulum_stability" / file)) << file;
  EXPECT_TRUE(text_in_png(read_text(folder / "output/pendulum_stability/figures/stability_rk4.png"),
                          renderer_keyword, "figure"));
  EXPECT_NE(ended.out.find("rk4: accurate up to a step of"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("critical step: rk4, f = 5, 2 elements"), std::string::npos) << ended.out;
}

TEST(StabilityProgram, ReportFromAStudySaysWhatTheStudySaid) {
  const TemporaryFolder folder;
  const Ended made = plumb_in(folder.path(), stability_command({"-o", "a", "--json"}));
  EXPECT_EQ(Json::parse(made.out), Json::parse(read_text(folder / "a/results.json")));
  for (const char* from : {"a", "a/study.json"}) {
    const Ended ended = plumb_in(folder.path(), {"report", from, "-o", "b"});
    EXPECT_EQ(ended.status, made.status) << ended.err;
    Json a = Json::parse(read_text(folder / "a/results.json")),
         b = Json::parse(read_text(folder / "b/results.json"));
    a.erase("seconds");
    b.erase("seconds");
    EXPECT_EQ(a, b);
    EXPECT_EQ(read_text(folder / "a/study.json"), read_text(folder / "b/study.json"));
  }
}

TEST(StabilityProgram, ADamagedStudyIsRefusedInOneLine) {
  const TemporaryFolder folder;
  write_text(folder / "a/study.json", "{\"kind\":\"stability\",\"version\":1}");
  const Ended ended = plumb_in(folder.path(), {"report", "a"});
  EXPECT_EQ(ended.status, 3) << ended.err;
  expect_one_line(ended.err);
}

TEST(StabilityProgram, AnInvalidParameterValueIsRefusedBeforeAnythingRuns) {
  const TemporaryFolder folder;
  const Ended ended =
      plumb_in(folder.path(), stability_command({"--set", "study.stability.parameter_values=[5,0]"}));
  EXPECT_EQ(ended.status, 3) << ended.err;
  EXPECT_NE(ended.err.find("cable.area"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(folder / "output/pendulum_stability"));
}

TEST(StabilityProgram, InterruptedItLeavesNothing) {
  const TemporaryFolder folder;
  std::vector<std::string> command =
      stability_command({"-o", "a", "--set", "time.end=20", "--set", "study.stability.durations=[20]"});
  command.insert(command.begin(), PLUMB_PROGRAM);
  const pid_t child = start(command, folder.path());
  // Once its folder is in the making, it listens.
  const auto made = [&] {
    for (const auto& entry : fs::directory_iterator(folder.path()))
      if (entry.is_directory()) return true;
    return false;
  };
  while (!made() && ::waitpid(child, nullptr, WNOHANG) == 0) ::usleep(1000);
  ::kill(child, SIGINT);
  const Ended ended = finish(child, folder.path());
  EXPECT_EQ(ended.status, 130) << ended.out << ended.err;
  EXPECT_FALSE(fs::exists(folder / "a"));
}

}  // namespace stability_program_test
}  // namespace plumb
