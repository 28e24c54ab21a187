#include "tests/report/program/program.h"

#include <nlohmann/json.hpp>

namespace plumb {
namespace program_test {

using Json = nlohmann::json;

/// A pendulum so short that everything about it is quick.
const std::vector<std::string> quick{"--set", "time.end=0.1",
                                     "--set", "reference.0.coverage.to=0.1",
                                     "--set", "reference.1.coverage.to=0.1",
                                     "--set", "scene.size=[160,90]"};
const std::vector<std::string> no_study{"--set", "study={}"};
const std::vector<std::string> small_study{"--set", "study.work_precision.quick.points=3",
                                           "--set", "study.work_precision.quick.elements=[4]",
                                           "--set", "study.work_precision.quick.methods=[\"rk4\"]"};

std::vector<std::string> with_quick(std::vector<std::string> arguments,
                                    const std::vector<std::string>& study = no_study) {
  for (const auto* more : {&quick, &study}) arguments.insert(arguments.end(), more->begin(), more->end());
  return arguments;
}

TEST(Program, RunsThePublishedPendulumToWithinTheRoundingOfItsFigures) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(
      folder.path(), {"run", case_path("pendulum_published.toml"), "--json", "--set", "scene.size=[160,90]"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json json = Json::parse(ended.out);
  std::size_t points = 0;
  for (const Json& error : json["errors"]) {
    points += error["points"].get<std::size_t>();
    EXPECT_LE(error["max"].get<double>(), 1e-5) << error["column"];
    EXPECT_GT(error["max"].get<double>(), 1e-6) << "rounded figures cannot be met this closely";
  }
  EXPECT_EQ(points, 303u);
  EXPECT_EQ(json["verdicts"].size(), 3u);
  for (const Json& verdict : json["verdicts"]) EXPECT_EQ(verdict["kind"], "validation");
  for (const char* file : {"index.html", "results.json", "junit.xml", "summary.md", "run.h5", "probes.csv",
                           "animation.png", "frames/0000.png", "frames/0050.png", "figures/mid_height.png",
                           "figures/tip_plan.png", "figures/energy.png"})
    EXPECT_TRUE(fs::exists(folder / "output/pendulum_published" / file)) << file;
  EXPECT_FALSE(fs::exists(folder / "output/pendulum_published/frames/0051.png"));
  EXPECT_FALSE(fs::exists(folder / "output/pendulum_published/study.h5")) << "the case asks for no study";
  EXPECT_FALSE(json.contains("work_precision"));
}

TEST(Program, CriterionThatIsNotMetEndsWithOneAndSaysByHowMuch) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(
      folder.path(), with_quick({"run", case_path("pendulum.toml"), "--set", "reference.0.tolerance=1e-6"}));
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.out.find("failed"), std::string::npos) << ended.out;
  const std::string page = read_text(folder / "output/pendulum/index.html");
  EXPECT_LT(page.find("class=\"tag failed\""), page.find("class=\"tag passed\""))
      << "failures must come first";
  EXPECT_NE(read_text(folder / "output/pendulum/junit.xml").find("failures=\"3\""), std::string::npos);
}

TEST(Program, AnotherCableIsNotValidatedByThePublishedFigures) {
  const TemporaryFolder folder;
  const Ended ended =
      plumb_in(folder.path(), with_quick({"run", case_path("pendulum.toml"), "--set", "parameters.f=4"}));
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_EQ(ended.out.find("passed"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("another cable: EA is 62.5 N"), std::string::npos) << ended.out;
}

TEST(Program, SolverThatFailsEndsWithFourAndKeepsWhatItHad) {
  const TemporaryFolder folder;
  const Ended ended =
      plumb_in(folder.path(),
               {"run", case_path("pendulum.toml"), "--set", "method.name=rk4", "--set", "method.step=1.5e-3",
                "--set", "time.output_interval=0.003", "--set", "scene.size=[160,90]", "--set", "study={}"});
  EXPECT_EQ(ended.status, 4) << ended.err << ended.out;
  const Json json = Json::parse(read_text(folder / "output/pendulum/results.json"));
  EXPECT_NE(json["solve"]["outcome"], "completed");
  EXPECT_FALSE(json["all_criteria_met"].get<bool>());
  const std::string message = json["solve"]["message"];
  EXPECT_NE(message.find("rk4 ended at t = "), std::string::npos) << message;
  for (const Json& verdict : json["verdicts"]) EXPECT_EQ(verdict["status"], "not run") << verdict;
  EXPECT_NE(read_text(folder / "output/pendulum/index.html").find("What went wrong:"), std::string::npos);
  EXPECT_NE(read_text(folder / "output/pendulum/junit.xml").find("<failure"), std::string::npos);
}

TEST(Program, SolveWritesTheProbesWithSeventeenDigits) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), {"solve", case_path("pendulum.toml"), "--set", "time.end=0.1",
                                               "--csv", "out.csv", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json json = Json::parse(ended.out);
  for (const char* key : {"outcome", "method", "elements", "end_time", "solve_seconds", "steps",
                          "force_evaluations", "tangent_evaluations", "newton_iterations", "energy_drift"})
    EXPECT_TRUE(json.contains(key)) << key;
  std::ifstream csv(folder / "out.csv");
  std::string header, row;
  std::getline(csv, header);
  EXPECT_EQ(header, "t [s],mid.x [m],mid.y [m],mid.z [m],tip.x [m],tip.y [m],tip.z [m]");
  std::getline(csv, row);
  EXPECT_EQ(row, "0,0.5,0,0,1,0,0");
  int rows = 1;
  while (std::getline(csv, row)) ++rows;
  EXPECT_EQ(rows, 6);
  EXPECT_FALSE(fs::exists(folder / "output")) << "--csv without -o writes no folder";
}

TEST(Program, WhatAVerbDoesNotUseItRemarksOnAtMost) {
  const TemporaryFolder folder;
  for (const std::string wrong :
       {"scene.frame_rate=1e9", "study.stability.steps=1", "uncertainty.elements=3"}) {
    const auto ended = [&](const std::string& verb) {
      return plumb_in(folder.path(),
                      {verb, case_path("pendulum.toml"), "--set", "time.end=0.1", "--set", wrong});
    };
    const Ended solved = ended("solve");
    EXPECT_EQ(solved.status, 0) << wrong << solved.err;
    EXPECT_NE(solved.err.find("is not used here"), std::string::npos) << wrong << solved.err;
    EXPECT_EQ(ended("check").status, 3) << wrong;
  }
  EXPECT_EQ(plumb_in(folder.path(), {"solve", case_path("economy/rod.toml"), "--economy", "--set",
                                     "time.end=0.1", "--set", "study.stability.steps=1"})
                .status,
            0)
      << "the case is read again with what its scene needs";
}

TEST(Program, EveryStageCanBeEnteredFromItsFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(plumb_in(folder.path(), with_quick({"solve", case_path("pendulum.toml"), "-o", "a"})).status, 0);
  EXPECT_TRUE(fs::exists(folder / "a/run.h5"));
  EXPECT_FALSE(fs::exists(folder / "a/index.html"));
  Ended ended = plumb_in(folder.path(), {"render", "a"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(fs::exists(folder / "a/animation.png"));
  EXPECT_TRUE(fs::exists(folder / "a/probes.csv"));
  ended = plumb_in(folder.path(), {"report", "a/run.h5", "-o", "b"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(fs::exists(folder / "b/index.html"));
  EXPECT_TRUE(fs::exists(folder / "b/run.h5"));
  EXPECT_FALSE(fs::exists(folder / "a/index.html"));
}

TEST(Program, ReportFromARunSaysWhatTheRunItselfSaid) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      plumb_in(folder.path(), with_quick({"run", case_path("pendulum.toml"), "-o", "a"}, small_study)).status,
      0);
  ASSERT_EQ(plumb_in(folder.path(), {"report", "a", "-o", "b"}).status, 0);
  Json a = Json::parse(read_text(folder / "a/results.json")),
       b = Json::parse(read_text(folder / "b/results.json"));
  for (Json* json : {&a, &b})
    for (const char* key : {"seconds", "check_sum"}) json->erase(key);
  EXPECT_EQ(a, b);
  EXPECT_EQ(read_text(folder / "a/frames/0001.png"), read_text(folder / "b/frames/0001.png"));
  EXPECT_EQ(read_text(folder / "a/figures/energy.png"), read_text(folder / "b/figures/energy.png"));
}

TEST(Program, CheckSaysThatTheShippedCasesAreValid) {
  const TemporaryFolder folder;
  for (const auto& entry : fs::directory_iterator(fs::path(PLUMB_SOURCE_DIR) / "cases"))
    if (entry.path().extension() == ".toml") {
      const Ended ended = plumb_in(folder.path(), {"check", entry.path().string()});
      EXPECT_EQ(ended.status, 0) << ended.err;
      EXPECT_NE(ended.out.find("is valid"), std::string::npos) << ended.out;
    }
}

TEST(Program, DoctorNamesRendererAndEveryMethod) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), {"doctor"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const char* name : {"llvmpipe", "linearly-implicit-euler", "rk4", "generalized-alpha", "cvode-bdf",
                           "arkode-erk", "cvode-adams", "arkode-dirk", "ida"})
    EXPECT_NE(ended.out.find(name), std::string::npos) << name << "\n" << ended.out;
}

TEST(Program, QuietSaysNothing) {
  const TemporaryFolder folder;
  const Ended ended =
      plumb_in(folder.path(), {"solve", case_path("pendulum.toml"), "--quiet", "--set", "time.end=0.1"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.out + ended.err, "");
}

}  // namespace program_test
}  // namespace plumb
