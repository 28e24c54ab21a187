#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/regression.h"
#include "tests/report/made_run.h"
#include "tests/report/program.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

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

Document document_with(double moved) {
  plumb::Run run = run_with("a");
  for (Eigen::VectorXd& q : run.trajectory.q) q.array() += moved;
  run.probes = probe(run.loaded.spec, run.trajectory);
  return document_of(evaluate(run, {}), {});
}

TEST(Regression, ARunThatIsRepeatedDoesNotMove) {
  Document document = document_with(0);
  hold_against_baseline(document, document_with(0), "first", default_regression_share);
  long regressions = 0;
  for (const Json& verdict : document.at("verdicts")) {
    if (verdict.at("kind") != "regression") continue;
    ++regressions;
    EXPECT_EQ(verdict.at("status"), "passed") << verdict;
    EXPECT_EQ(verdict.at("value"), 0) << verdict;
  }
  EXPECT_EQ(regressions, 4) << "that of the verdicts, and one a column";
  EXPECT_TRUE(document.at("baseline").at("changes").empty()) << document.at("baseline").at("changes");
}

TEST(Regression, MayMoveByTheShareThatIsGivenAndNoMore) {
  const Document before = document_with(0), now = document_with(1e-3);
  const auto passes = [&](double share) {
    Document document = now;
    hold_against_baseline(document, before, "first", share);
    return verdict_named(document, "baseline: tip.x").at("status") == "passed";
  };
  double largest = 0;
  for (const Json& value : before.at("probes").at("tip.x").at("values"))
    largest = std::max(largest, std::abs(value.get<double>()));
  EXPECT_TRUE(passes(1.001e-3 / largest)) << largest;
  EXPECT_FALSE(passes(0.999e-3 / largest)) << largest;
}

TEST(Regression, OtherOutputTimesAreNotCompared) {
  const Document before = document_with(0);
  Document document = before;
  document["probes"]["t"]["values"][0] = 0.001;
  hold_against_baseline(document, before, "first", default_regression_share);
  const Json verdict = verdict_named(document, "baseline: tip.x");
  EXPECT_EQ(verdict.at("status"), "not run") << verdict;
  EXPECT_NE(verdict.at("message").get<std::string>().find("other output times"), std::string::npos)
      << verdict;
  EXPECT_FALSE(document.at("all_criteria_met"));
}

TEST(Regression, NeverChangesTheOutcome) {
  Document document = document_with(1e-3);
  const std::string outcome = document.at("outcome");
  hold_against_baseline(document, document_with(0), "first", default_regression_share);
  EXPECT_EQ(document.at("outcome"), outcome);
  EXPECT_FALSE(document.at("all_criteria_met"));
}

TEST(Regression, AVerdictThatPassesNoLongerIsNamed) {
  const Document before = document_with(0);
  Document document = before;
  document["verdicts"][0]["status"] = "failed";
  hold_against_baseline(document, before, "first", default_regression_share);
  const Json verdict = verdict_named(document, "baseline: verdicts");
  EXPECT_EQ(verdict.at("value"), 1) << verdict;
  EXPECT_NE(verdict.at("message").get<std::string>().find(before["verdicts"][0]["name"]), std::string::npos)
      << verdict;
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

TEST_F(Baseline, IsRefusedBeforeAnyWork) {
  const auto refused = [&](const std::string& baseline, const std::string& reason) {
    const Ended ended = run("new", {"--baseline", baseline});
    EXPECT_EQ(ended.status, 3) << ended.err;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(reason), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder_ / "new"));
  };
  refused("nowhere", "No such file");
  EXPECT_EQ(run("new", {"--numbers", "1e-3"}).status, 2) << "it is the share of a baseline";
  write_text(folder_ / "text.json", "no JSON");
  refused("text.json", "not JSON");
  write_text(folder_ / "later.json", R"({"schema_version": 99})");
  refused("later.json", "schema_version is 99");
  write_text(folder_ / "other.json", R"({"schema_version": 2})");
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
