#include <nlohmann/json.hpp>

#include "tests/report/program/program.h"

namespace plumb {
namespace bring_your_own_test {

using Json = nlohmann::json;

const std::string folder_of_cases = PLUMB_SOURCE_DIR "/cases/";

/// The case alone with its files, to be changed.
void copy_case(const fs::path& to) {
  fs::create_directories(to / "references");
  for (const char* name : {"bring_your_own.toml", "bring_your_own.csv", "references/pendulum_converged.toml",
                           "references/pendulum_published.toml"})
    fs::copy_file(folder_of_cases + name, to / name);
}

TEST(BringYourOwn, TheTableIsWhatTheIndependentProgramPrints) {
  const TemporaryFolder folder;
  const Ended ended =
      run_command({"python3", PLUMB_SOURCE_DIR "/tests/independent_pendulum.py"}, folder.path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string committed = read_text(folder_of_cases + "bring_your_own.csv");
  const auto differs = std::mismatch(ended.out.begin(), ended.out.end(), committed.begin(), committed.end());
  EXPECT_TRUE(ended.out == committed) << "they differ from byte " << differs.first - ended.out.begin()
                                      << " of " << ended.out.size() << " and " << committed.size();
}

TEST(BringYourOwn, TheCaseIsReportedLikeARunOfPlumbs) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), {"run", folder_of_cases + "bring_your_own.toml", "--json",
                                               "--set", "scene.size=[160,90]"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json json = Json::parse(ended.out);
  ASSERT_EQ(json["verdicts"].size(), 6U);
  for (const Json& verdict : json["verdicts"]) {
    EXPECT_EQ(verdict["status"], "passed") << verdict;
    EXPECT_GT(verdict["value"].get<double>(), 1e-4) << "another model cannot be this close: " << verdict;
  }
  for (const Json& error : json["errors"])
    if (error["reference"] == "published") {
      EXPECT_EQ(error["points"], 101) << error["column"];
      EXPECT_EQ(error["interpolated_points"], 50) << "every 8 ms against every 20 ms";
    }
  EXPECT_TRUE(json["energy"].is_null());
  EXPECT_EQ(json["given_runs"][0]["columns"]["tip.x"]["file_unit"], "mm");
  const fs::path output = folder / "output/bring_your_own";
  for (const char* file : {"index.html", "results.json", "junit.xml", "summary.md", "run.h5", "probes.csv",
                           "animation.png", "frames/0000.png", "frames/0050.png", "figures/mid_height.png"})
    EXPECT_TRUE(fs::exists(output / file)) << file;
  EXPECT_FALSE(fs::exists(output / "figures/energy.png"));
  const std::string page = read_text(output / "index.html");
  EXPECT_NE(page.find("drawn through 5 places (the held first end, quarter, mid, three_quarters, tip), as a "
                      "natural cubic spline"),
            std::string::npos);
}

TEST(BringYourOwn, AReportIsMadeAgainFromTheRunFileWhereTheTableIsGone) {
  const TemporaryFolder folder;
  copy_case(folder / "mine");
  ASSERT_EQ(plumb_in(folder.path(), {"run", "mine/bring_your_own.toml", "-o", "out", "--set",
                                     "scene.size=[160,90]", "--set", "scene.frame_rate=2"})
                .status,
            0);
  fs::remove_all(folder / "mine");
  const std::string first = read_text(folder / "out/probes.csv");
  const Ended ended = plumb_in(folder.path(), {"report", "out"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(read_text(folder / "out/probes.csv"), first);
  const std::string page = read_text(folder / "out/index.html");
  const Ended from = plumb_in(folder.path(), {"report", "--from", "out/results.json"});
  EXPECT_EQ(from.status, 0) << from.err;
  EXPECT_EQ(read_text(folder / "out/index.html"), page);
  EXPECT_EQ(first.substr(0, first.find('\n')).find("t [s],quarter.x [m],"), 0U) << first.substr(0, 80);
  const Ended frames = plumb_in(folder.path(), {"render", "out", "-o", "-", "--frames", "3"});
  EXPECT_EQ(frames.status, 0) << frames.err;
  EXPECT_EQ(frames.out.substr(1, 3), "PNG");
}

TEST(BringYourOwn, WithAMethodPlumbsOwnRunIsReportedAndTheGivenOneLiesOverIt) {
  const TemporaryFolder folder;
  const Ended ended =
      plumb_in(folder.path(), {"run", folder_of_cases + "bring_your_own.toml", "--json", "--set",
                               "method.name=arkode-erk", "--set", "cable.elements=8", "--set",
                               "time.output_interval=0.004", "--set", "scene.size=[160,90]", "--set",
                               "scene.frame_rate=1", "--set", "run.0.tolerances={ \"tip.x\" = 4e-3 }"});
  EXPECT_EQ(ended.status, 1) << "4e-3 m is closer than the two models are: " << ended.err;
  const Json json = Json::parse(ended.out);
  ASSERT_EQ(json["verdicts"].size(), 13U);
  EXPECT_EQ(json["verdicts"][0]["name"], "converged: mid.y");
  EXPECT_EQ(json["verdicts"][6]["name"], "springs: converged: mid.y");
  EXPECT_EQ(json["verdicts"][12]["name"], "springs: Plumb: tip.x");
  EXPECT_EQ(json["verdicts"][12]["status"], "failed");
  EXPECT_EQ(json["reported"], "Plumb");
  EXPECT_FALSE(json["energy"].is_null());
  double worst = 0;
  for (const Json& distance : json["given_runs"][0]["distances"]) {
    EXPECT_EQ(distance["coverage"]["compared"], 501) << "every 8 ms and every 4 ms";
    worst = std::max(worst, distance["max"].get<double>());
  }
  EXPECT_GT(worst, 1e-4);
  EXPECT_LT(worst, 0.02) << "m, between two models of one cable";
  const std::string figure = read_text(folder / "output/bring_your_own/figures/mid_height.csv");
  EXPECT_NE(figure.find("springs"), std::string::npos);
  EXPECT_NE(figure.find("Plumb"), std::string::npos);
  const std::string page = read_text(folder / "output/bring_your_own/index.html");
  EXPECT_NE(page.find("Distance of springs to Plumb"), std::string::npos);
}

TEST(BringYourOwn, WithoutEnoughPlacesThereIsAReportAndNoAnimation) {
  const TemporaryFolder folder;
  copy_case(folder / "mine");
  const std::vector<std::string> free{"--set", "supports.first=free",
                                      "--set", "probe=[{name=\"mid\",at=0.5}]",
                                      "--set", "run.0.columns={t=\"Time\",\"mid.y\"=\"Middle Y\"}",
                                      "--set", "reference=[]",
                                      "--set", "figure=[]"};
  std::vector<std::string> run{"run", "mine/bring_your_own.toml", "-o", "out"};
  run.insert(run.end(), free.begin(), free.end());
  const Ended ended = plumb_in(folder.path(), run);
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("animation: springs gives positions, with their three components, at no place"),
            std::string::npos)
      << ended.out;
  EXPECT_FALSE(fs::exists(folder / "out/animation.png"));
  EXPECT_FALSE(fs::exists(folder / "out/frames"));
  const Ended frames = plumb_in(folder.path(), {"render", "out", "-o", "-"});
  EXPECT_EQ(frames.status, 5) << frames.err;
  EXPECT_NE(frames.err.find("there are no frames"), std::string::npos) << frames.err;
}

TEST(BringYourOwn, WithoutAMethodThereIsNothingToSolveOrStudy) {
  const TemporaryFolder folder;
  for (const char* verb : {"solve", "study"}) {
    const Ended ended = plumb_in(folder.path(), {verb, folder_of_cases + "bring_your_own.toml"});
    EXPECT_EQ(ended.status, 2) << verb << ": " << ended.err;
    EXPECT_NE(ended.err.find("has no [method]"), std::string::npos) << ended.err;
  }
  EXPECT_FALSE(fs::exists(folder / "output"));
}

TEST(BringYourOwn, CheckSaysWhatTheFileHolds) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), {"check", folder_of_cases + "bring_your_own.toml"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("an external run to 2 s, 6 criteria"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("springs: 12 columns of tests/independent_pendulum.py"), std::string::npos)
      << ended.out;
  EXPECT_NE(ended.out.find("251 rows from 0 to 2 s"), std::string::npos) << ended.out;
}

TEST(BringYourOwn, AFaultInTheTableEndsWithThreeAndItsPlaceAndLeavesNothing) {
  const TemporaryFolder folder;
  copy_case(folder / "mine");
  std::string text = read_text(folder / "mine/bring_your_own.csv");
  text.replace(text.find("\n8,") + 1, 1, "eight");
  write_text(folder / "mine/bring_your_own.csv", text);
  const Ended ended = plumb_in(folder.path(), {"run", "mine/bring_your_own.toml"});
  EXPECT_EQ(ended.status, 3);
  expect_one_line(ended.err);
  EXPECT_NE(ended.err.find("mine/bring_your_own.csv:3:1: Time = \"eight\": must be a finite number"),
            std::string::npos)
      << ended.err;
  EXPECT_FALSE(fs::exists(folder / "output"));
}

TEST(BringYourOwn, ATableThatIsTooLargeIsRefused) {
  const TemporaryFolder folder;
  copy_case(folder / "mine");
  fs::resize_file(folder / "mine/bring_your_own.csv", 65UL * 1024 * 1024);
  const Ended ended = plumb_in(folder.path(), {"check", "mine/bring_your_own.toml"});
  EXPECT_EQ(ended.status, 3);
  expect_one_line(ended.err);
  EXPECT_NE(ended.err.find("longer than 64 MiB"), std::string::npos) << ended.err;
}

TEST(BringYourOwn, ARunFileOfPlumbsIsAGivenRunAsItIs) {
  const TemporaryFolder folder;
  copy_case(folder / "mine");
  const std::vector<std::string> plumb_method{
      "--set", "method.name=rk4",           "--set", "method.step=1e-3", "--set", "cable.elements=4",
      "--set", "time.output_interval=0.02", "--set", "time.end=0.2"};
  std::vector<std::string> solve{"solve", "mine/bring_your_own.toml", "-o", "mine/solved"};
  solve.insert(solve.end(), plumb_method.begin(), plumb_method.end());
  ASSERT_EQ(plumb_in(folder.path(), solve).status, 0);
  std::vector<std::string> run{"run",   "mine/bring_your_own.toml",     "-o",    "out",
                               "--set", "run.0.file=\"solved/run.h5\"", "--set", "run.0.columns={}",
                               "--set", "scene.size=[160,90]",          "--json"};
  run.insert(run.end(), plumb_method.begin(), plumb_method.end());
  const Ended ended = plumb_in(folder.path(), run);
  ASSERT_NE(ended.out, "") << ended.err;
  const Json json = Json::parse(ended.out);
  ASSERT_EQ(json["given_runs"][0]["distances"].size(), 12U);
  for (const Json& distance : json["given_runs"][0]["distances"]) EXPECT_EQ(distance["max"], 0) << distance;
  fs::remove_all(folder / "mine");
  const Ended again = plumb_in(folder.path(), {"report", "out", "--json"});
  ASSERT_NE(again.out, "") << again.err;
  EXPECT_EQ(Json::parse(again.out)["given_runs"], json["given_runs"]) << "a run file within a run file";
}

TEST(GivenRunInAStudy, IsReportedAgainWhereItsFileIsGone) {
  const TemporaryFolder folder;
  for (const char* name : {"bring_your_own.toml", "bring_your_own.csv", "references/pendulum_published.toml",
                           "references/pendulum_converged.toml"})
    write_text(folder / name, read_text(case_path(name)));
  const Ended study =
      plumb_in(folder.path(), {"study", "bring_your_own.toml", "sweep", "-o", "out", "--set",
                               "method.name=rk4", "--set", "method.step=1e-3", "--set", "cable.elements=4",
                               "--set", "time.output_interval=0.02", "--set", "study.sweep.cases=2"});
  ASSERT_TRUE(fs::exists(folder / "out/study.json")) << study.out << study.err;
  fs::remove(folder / "bring_your_own.csv");
  const Ended again = plumb_in(folder.path(), {"report", "out"});
  EXPECT_EQ(again.status, study.status) << again.out << again.err;
}

}  // namespace bring_your_own_test
}  // namespace plumb
