#include <nlohmann/json.hpp>

#include "tests/report/program/program.h"

namespace plumb {
namespace several_reports_test {

using Json = nlohmann::json;

/// Two small cases of one kind in a folder, with small pictures, which are not looked at here.
class SeveralReports : public ::testing::Test {
 protected:
  SeveralReports() {
    const fs::path data = fs::path(PLUMB_SOURCE_DIR) / "tests/data";
    write_text(folder_ / "small_reference.toml", read_text(data / "small_reference.toml"));
    std::string text = read_text(data / "small_case.toml");
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"size = [640, 480]", "size = [64, 48]"},
          {"frame_rate = 10", "frame_rate = 1"}})
      text.replace(text.find(from), from.size(), to);
    for (const char* name : {"one.toml", "two.toml"}) write_text(folder_ / name, text);
  }

  Ended plumb(const std::vector<std::string>& arguments) { return plumb_in(folder_.path(), arguments); }
  Json results(const std::string& name) { return Json::parse(read_text(folder_ / name)); }

  TemporaryFolder folder_;
};

TEST_F(SeveralReports, CasesRunIntoAnIndex) {
  const Ended ended = plumb({"run", "one.toml", "two.toml", "-o", "all"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  const Json index = results("all/results.json");
  EXPECT_EQ(index.at("kind"), "index");
  ASSERT_EQ(index.at("reports").size(), 2U);
  EXPECT_EQ(index["reports"][0].at("verdicts").size(), results("all/one/results.json").at("verdicts").size());
  EXPECT_FALSE(index.at("figures").empty());
  for (const Json& figure : index.at("figures"))
    EXPECT_TRUE(fs::exists(folder_ / "all" / figure.at("file").get<std::string>())) << figure;
  for (const char* name : {"all/index.html", "all/junit.xml", "all/summary.md", "all/two/index.html"})
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_NE(read_text(folder_ / "all/index.html").find("href=\"one/index.html\""), std::string::npos);
  EXPECT_NE(read_text(folder_ / "all/junit.xml").find("two.validation"), std::string::npos);
}

TEST_F(SeveralReports, PatternsStandForWhatTheyMatch) {
  plumb({"run", "*o*.toml", "-o", "all", "--set", "time.end=0.5"});  // not the reference, which has no o
  EXPECT_TRUE(fs::exists(folder_ / "all/one/run.h5"));
  EXPECT_TRUE(fs::exists(folder_ / "all/two/run.h5"));
  const Ended nothing = plumb({"run", "x*.toml", "-o", "none"});
  EXPECT_EQ(nothing.status, 2);
  expect_one_line(nothing.err);
}

TEST_F(SeveralReports, FailureIsFirstInTheIndex) {
  write_text(folder_ / "zero.toml", read_text(folder_ / "one.toml"));
  plumb({"run", "one.toml", "-o", "a"});
  const Ended failed =
      plumb({"run", "zero.toml", "-o", "z", "--set", "method.name=rk4", "--set", "method.step=0.02"});
  EXPECT_EQ(failed.status, 4) << failed.out << failed.err;
  const Ended ended = plumb({"report", "a", "z", "-o", "."});
  EXPECT_EQ(ended.status, 4) << ended.err;
  const Json index = results("results.json");
  EXPECT_EQ(index.at("reports")[0].at("folder"), "z");
  EXPECT_FALSE(index.at("all_criteria_met"));
  EXPECT_NE(index.at("headline").get<std::string>().find("z"), std::string::npos);
}

TEST_F(SeveralReports, TwoStandBesideOneAnotherAndMoreDoNot) {
  plumb({"run", "one.toml", "-o", "a"});
  plumb({"run", "two.toml", "-o", "b", "--set", "time.output_interval=0.07", "--set", "cable.density=1100"});
  const Ended ended = plumb({"report", "a", "b", "-o", "."});
  EXPECT_LE(ended.status, 1) << ended.err;
  const Json index = results("results.json");
  const Json& beside = index.at("beside");
  EXPECT_EQ(beside.at("first"), "a");
  EXPECT_EQ(beside.at("second"), "b");
  EXPECT_FALSE(beside.at("verdicts").empty());
  EXPECT_FALSE(beside.at("probes").empty());
  for (const Json& probe : beside.at("probes")) EXPECT_EQ(probe.at("interpolated"), true) << probe;
  EXPECT_NE(beside.at("case").dump().find("density"), std::string::npos) << beside.at("case");
  EXPECT_NE(ended.out.find(beside.at("headline").get<std::string>()), std::string::npos) << ended.out;
  const std::string page = read_text(folder_ / "index.html");
  EXPECT_NE(page.find("id=\"beside\""), std::string::npos);
  EXPECT_NE(page.find("class=\"pair\""), std::string::npos) << "their pictures";
  EXPECT_LT(page.size(), 5'000'000U);
  const Ended three = plumb({"report", "a", "b", "a", "-o", "."});
  EXPECT_LE(three.status, 1) << three.err;
  EXPECT_FALSE(results("results.json").contains("beside"));
}

TEST_F(SeveralReports, MayBeOfStudiesAndOfBoth) {
  write_text(folder_ / "swept.toml",
             read_text(fs::path(PLUMB_SOURCE_DIR) / "cases/failure/random_sweep.toml"));
  for (const auto& [name, cases] : {std::pair<std::string, std::string>{"s1", "2"}, {"s2", "3"}}) {
    const Ended study = plumb({"study", "swept.toml", "sweep", "-o", name, "--set",
                               "study.sweep.cases=" + cases, "--set", "time.end=0.05"});
    ASSERT_LE(study.status, 1) << study.err;
  }
  const Ended ended = plumb({"report", "s1", "s2", "-o", "both"});
  EXPECT_LE(ended.status, 1) << ended.err;
  const Json index = results("both/results.json");
  ASSERT_EQ(index.at("reports").size(), 2U);
  EXPECT_FALSE(index.at("beside").at("numbers").empty()) << index.at("beside");
  EXPECT_NE(read_text(folder_ / "both/index.html").find("class=\"pair\""), std::string::npos);
  EXPECT_EQ(read_text(folder_ / "both/junit.xml").find("integration"), std::string::npos);

  plumb({"run", "one.toml", "-o", "a"});
  const Ended mixed = plumb({"report", "a", "s1", "-o", "mixed"});
  EXPECT_LE(mixed.status, 1) << mixed.err;
  EXPECT_NE(results("mixed/results.json").at("beside").at("not_compared").dump().find("results of the study"),
            std::string::npos);
  const Ended history = plumb({"report", "a", "s1", "-o", "bad", "--history", "h.jsonl"});
  EXPECT_EQ(history.status, 2);
  expect_one_line(history.err);
  EXPECT_FALSE(fs::exists(folder_ / "bad"));
  std::string damaged = read_text(folder_ / "s1/results.json");
  damaged.replace(damaged.find("\"verdicts\""), 10, "\"verdict_s\"");
  write_text(folder_ / "s1/results.json", damaged);
  const Ended broken = plumb({"report", "a", "s1", "-o", "bad"});
  EXPECT_EQ(broken.status, 3) << broken.err;
  expect_one_line(broken.err);
}

TEST_F(SeveralReports, ARunWithoutAReportIsNotTakenForAnEarlierOne) {
  plumb({"run", "one.toml", "two.toml", "-o", "all"});
  ASSERT_TRUE(fs::exists(folder_ / "all/one/results.json"));
  // A start that is not finite.
  const Ended ended = plumb({"run", "one.toml", "two.toml", "-o", "all", "--set", "cable.length=1e200",
                             "--set", "start.angular_velocity=[0,1e308,1e308]"});
  EXPECT_EQ(ended.status, 4) << ended.err;
  const Json index = results("all/results.json");
  ASSERT_EQ(index.at("reports").size(), 2U);
  for (const Json& report : index.at("reports")) EXPECT_EQ(report.at("headline"), "The run left no report.");
  EXPECT_FALSE(index.at("all_criteria_met"));
  EXPECT_NE(read_text(folder_ / "all/junit.xml").find("the run left no report"), std::string::npos);
}

TEST_F(SeveralReports, NothingIsRunWhereOneCaseIsWrong) {
  write_text(folder_ / "wrong.toml", "title = 3");
  const Ended ended = plumb({"run", "one.toml", "wrong.toml", "-o", "all"});
  EXPECT_EQ(ended.status, 3);
  expect_one_line(ended.err);
  EXPECT_FALSE(fs::exists(folder_ / "all"));
}

TEST_F(SeveralReports, CasesOfOneNameAreRefused) {
  write_text(folder_ / "below/one.toml", read_text(folder_ / "one.toml"));
  const Ended ended = plumb({"run", "one.toml", "below/one.toml", "-o", "all"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("would both be written to all/one"), std::string::npos) << ended.err;
}

TEST_F(SeveralReports, CasesThatHaveTheNameOfAFileOfTheIndexAreRefused) {
  for (const std::string name :
       {"manifest.json", "index.html", "results.json", "junit.xml", "summary.md", "figures"}) {
    write_text(folder_ / (name + ".toml"), read_text(folder_ / "one.toml"));
    const Ended ended = plumb({"run", "one.toml", name + ".toml", "-o", "all"});
    EXPECT_EQ(ended.status, 2) << name;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(name + ".toml: its results would be in all/" + name), std::string::npos)
        << ended.err;
  }
  for (const std::string name : {"...toml", "..toml"}) {
    write_text(folder_ / name, read_text(folder_ / "one.toml"));
    for (const auto& arguments :
         {std::vector<std::string>{"run", "one.toml", "./" + name},
          std::vector<std::string>{"run", "./" + name}, std::vector<std::string>{"solve", "./" + name}}) {
      const Ended ended = plumb(arguments);
      EXPECT_EQ(ended.status, 2) << name;
      expect_one_line(ended.err);
      EXPECT_NE(ended.err.find("./" + name + ": its results would be in a folder"), std::string::npos)
          << ended.err;
    }
  }
  EXPECT_FALSE(fs::exists(folder_ / "all"));
  EXPECT_FALSE(fs::exists(folder_ / "output"));
}

TEST_F(SeveralReports, ReportThatIsNotThereIsRefused) {
  const Ended ended = plumb({"report", "a", "b", "-o", "all"});
  EXPECT_EQ(ended.status, 3);
  expect_one_line(ended.err);
  EXPECT_FALSE(fs::exists(folder_ / "all"));
}

class ReportFromDocument : public SeveralReports {
 protected:
  ReportFromDocument() { plumb({"run", "one.toml", "-o", "run"}); }
};

TEST_F(ReportFromDocument, GivesTheSameFiles) {
  std::map<std::string, std::string> before;
  for (const char* name : {"run/index.html", "run/junit.xml", "run/summary.md"}) {
    before[name] = read_text(folder_ / name);
    fs::remove(folder_ / name);
  }
  fs::remove(folder_ / "run/run.h5");
  const Ended ended = plumb({"report", "--from", "run/results.json"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  for (const auto& [name, bytes] : before) EXPECT_TRUE(read_text(folder_ / name) == bytes) << name;
}

TEST_F(ReportFromDocument, SaysWhatIsWrongWithIt) {
  const auto refused = [&](const std::string& text, const std::string& reason) {
    write_text(folder_ / "run/other.json", text);
    const Ended ended = plumb({"report", "--from", "run/other.json", "-o", "new"});
    EXPECT_EQ(ended.status, 3) << ended.err;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(reason), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder_ / "new"));
  };
  Json document = results("run/results.json");
  const auto changed = [&](auto change) {
    Json other = document;
    change(other);
    other.erase("check_sum");
    return other.dump();
  };
  refused("[]", "no results of Plumb");
  refused("{", "not JSON");
  refused(changed([](Json& json) { json["schema_version"] = 7; }), "schema_version is 7");
  refused(changed([](Json& json) { json.erase("energy"); }), "energy is missing");
  refused(changed([](Json& json) { json["solve"].erase("steps"); }), "steps");
  refused(changed([](Json& json) { json["title"] = 3; }), "another type");
  refused(changed([](Json& json) { json["verdicts"][0]["kind"] = "opinion"; }), "opinion");
  refused(changed([](Json& json) { json["case"]["method"]["name"] = "magic"; }), "magic");
  Json met = document;
  met["title"] = "another";
  refused(met.dump(), "it was changed after it was written: its check_sum is not that of its content");
  fs::remove(folder_ / "run/player.png");
  refused(document.dump(), "player.png");
}

TEST_F(ReportFromDocument, TakesThePlaceOfARun) {
  EXPECT_EQ(plumb({"report", "--from", "run/results.json", "run"}).status, 2);
  EXPECT_EQ(plumb({"report"}).status, 2);
}

}  // namespace several_reports_test
}  // namespace plumb
