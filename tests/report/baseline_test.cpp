#include <nlohmann/json.hpp>

#include "tests/report/program.h"

namespace plumb {
namespace {

using Json = nlohmann::json;

std::string small_case() {
  return std::string(PLUMB_SOURCE_DIR) + "/tests/data/small_case.toml";
}

Json results_in(const fs::path& folder) {
  return Json::parse(read_text(folder / "results.json"));
}

Json verdict_named(const Json& results, const std::string& name) {
  for (const Json& verdict : results.at("verdicts"))
    if (verdict.at("name") == name) return verdict;
  return {};
}

class Baseline : public ::testing::Test {
 protected:
  Ended run(const std::string& into, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"run", small_case(), "-o", into};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return plumb_in(folder_.path(), arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(Baseline, RunThatIsRepeatedDoesNotMove) {
  run("first");
  run("again", {"--baseline", "first"});
  const Json results = results_in(folder_ / "again");
  for (const char* name : {"baseline: verdicts", "baseline: mid.x", "baseline: pull"}) {
    const Json verdict = verdict_named(results, name);
    ASSERT_FALSE(verdict.is_null()) << name;
    EXPECT_EQ(verdict.at("kind"), "regression");
    EXPECT_EQ(verdict.at("status"), "passed") << verdict;
    EXPECT_EQ(verdict.at("value"), 0) << verdict;
  }
  EXPECT_TRUE(results.at("baseline").at("changes").empty()) << results.at("baseline").at("changes");
}

TEST_F(Baseline, RunThatMovedFailsWithHowFar) {
  run("first");
  const Ended ended = run("moved", {"--baseline", "first", "--set", "loads.gravity=[0,-9.8,0]"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  const Json results = results_in(folder_ / "moved");
  const Json verdict = verdict_named(results, "baseline: mid.y");
  EXPECT_EQ(verdict.at("status"), "failed") << verdict;
  EXPECT_GT(verdict.at("value").get<double>(), 1e-4) << verdict;
  EXPECT_FALSE(results.at("all_criteria_met"));
  bool told = false;
  for (const Json& change : results.at("baseline").at("changes"))
    told |= change.at("what") == "loads.gravity" &&
            change.at("now").get<std::string>().find("-9.8") != std::string::npos;
  EXPECT_TRUE(told) << results.at("baseline").at("changes");
  EXPECT_NE(read_text(folder_ / "moved/junit.xml").find("<testsuite name=\"regression\""), std::string::npos);
  EXPECT_NE(read_text(folder_ / "moved/index.html").find("What changed"), std::string::npos);
}

TEST_F(Baseline, WhatMayMoveCanBeSaid) {
  run("first");
  run("moved", {"--baseline", "first", "--numbers", "0.1", "--set", "loads.gravity=[0,-9.8,0]"});
  EXPECT_EQ(verdict_named(results_in(folder_ / "moved"), "baseline: mid.y").at("status"), "passed");
}

TEST_F(Baseline, OtherOutputTimesAreNotCompared) {
  run("first");
  const Ended ended = run("other", {"--baseline", "first", "--set", "time.output_interval=0.05"});
  EXPECT_EQ(ended.status, 1);
  const Json verdict = verdict_named(results_in(folder_ / "other"), "baseline: mid.y");
  EXPECT_EQ(verdict.at("status"), "not run") << verdict;
  EXPECT_NE(verdict.at("message").get<std::string>().find("other output times"), std::string::npos)
      << verdict;
}

TEST_F(Baseline, RegressionNeverChangesTheOutcome) {
  run("first");
  const std::string outcome = results_in(folder_ / "first").at("outcome");
  run("moved", {"--baseline", "first", "--set", "loads.gravity=[0,-9.8,0]"});
  EXPECT_EQ(results_in(folder_ / "moved").at("outcome"), outcome);
}

TEST_F(Baseline, IsRefusedBeforeAnyWork) {
  const auto refused = [&](const std::string& baseline, const std::string& reason) {
    const Ended ended = run("new", {"--baseline", baseline});
    EXPECT_EQ(ended.status, 3) << ended.err;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(reason), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder_ / "new"));
  };
  refused("nowhere", "No such file");
  write_text(folder_ / "text.json", "no JSON");
  refused("text.json", "not JSON");
  write_text(folder_ / "later.json", R"({"schema_version": 99})");
  refused("later.json", "schema_version is 99");
  write_text(folder_ / "other.json", R"({"schema_version": 1})");
  refused("other.json", "is missing: not the results of a run");
}

TEST_F(Baseline, LastRunInTheFolderIsToldOf) {
  run("same");
  EXPECT_FALSE(results_in(folder_ / "same").contains("last_run"));
  run("same");
  EXPECT_TRUE(results_in(folder_ / "same").at("last_run").at("changes").empty());
  run("same", {"--set", "cable.elements=5"});
  const Json changes = results_in(folder_ / "same").at("last_run").at("changes");
  bool told = false;
  for (const Json& change : changes)
    told |= change.at("what") == "cable.elements" && change.at("before") == "4" && change.at("now") == "5";
  EXPECT_TRUE(told) << changes;
}

}  // namespace
}  // namespace plumb
