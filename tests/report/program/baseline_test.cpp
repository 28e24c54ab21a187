#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "render/image/png.h"
#include "report/diff/picture_moves.h"
#include "report/document/regression.h"
#include "tests/report/made_run.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace baseline_test {

using Json = nlohmann::ordered_json;

std::string small_case() {
  return PLUMB_SOURCE_DIR "/tests/data/small_case.toml";
}

Json results_in(const fs::path& folder) {
  return Json::parse(read_text(folder / "results.json"));
}

Json verdict_named(const Json& results, const std::string& name) {
  for (const Json& verdict : results.at("verdicts"))
    if (verdict.at("name") == name) return verdict;
  return {};
}

/// A sentence as the name of a test.
std::string as_name(std::string sentence) {
  for (char& c : sentence)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return sentence;
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

/// What is done to a baseline, and what becomes of the run that is held against it.
struct ChangedBaseline {
  const char* sentence;
  void (*change)(Document& before, Document& now);
  const char* verdict;  ///< the one that is looked at
  const char* status;
  const char* says;  ///< a part of its message
};

Document& values_of(Document& document, const char* column) {
  return document["probes"][column]["values"];
}

const ChangedBaseline changed_baselines[] = {
    {"nothing is changed", [](Document&, Document&) {}, "baseline: tip.x", "passed", "the same to the last"},
    {"another output time", [](Document&, Document& now) { values_of(now, "t")[1] = 0.501; },
     "baseline: tip.x", "failed", "other output times"},
    {"another first output time", [](Document&, Document& now) { values_of(now, "t")[0] = 0.001; },
     "baseline: tip.x", "failed", "other output times"},
    {"an output time that is not a number",
     [](Document& before, Document& now) { values_of(now, "t")[2] = values_of(before, "t")[2] = nullptr; },
     "baseline: tip.x", "failed", "other output times"},
    {"one output more",
     [](Document&, Document& now) {
       for (auto& [name, column] : now["probes"].items()) column["values"].push_back(1.5);
     },
     "baseline: tip.x", "failed", "other output times (3, this run 4)"},
    {"one output less",
     [](Document&, Document& now) {
       for (auto& [name, column] : now["probes"].items()) column["values"].erase(2);
     },
     "baseline: tip.x", "failed", "other output times (3, this run 2)"},
    {"a column that is shorter than its times",
     [](Document& before, Document&) { values_of(before, "tip.x").erase(2); }, "baseline: tip.x", "failed",
     "2 values in the earlier report and 3 in this run at 3 times"},
    {"no output at all",
     [](Document& before, Document& now) {
       for (Document* one : {&before, &now})
         for (auto& [name, column] : (*one)["probes"].items()) column["values"] = Document::array();
     },
     "baseline: tip.x", "failed", "no output after the start"},
    {"the start alone",
     [](Document& before, Document& now) {
       for (Document* one : {&before, &now})
         for (auto& [name, column] : (*one)["probes"].items())
           column["values"] = Document::array({column["values"][0]});
     },
     "baseline: tip.x", "failed", "no output after the start"},
    {"a column that the run lacks", [](Document&, Document& now) { now["probes"].erase("tip.y"); },
     "baseline: tip.y", "failed", "this run has no such column"},
    {"a column that the baseline lacks", [](Document& before, Document&) { before["probes"].erase("tip.y"); },
     "baseline: tip.y", "failed", "the earlier report has no such column"},
    {"another unit", [](Document& before, Document&) { before["probes"]["tip.x"]["unit"] = "mm"; },
     "baseline: tip.x", "failed", "another unit"},
    {"what is not a number in the run",
     [](Document&, Document& now) { values_of(now, "tip.x")[1] = nullptr; }, "baseline: tip.x", "failed",
     "not a number at 0.5 s"},
    {"what is not a number in the baseline",
     [](Document& before, Document&) { values_of(before, "tip.x")[1] = nullptr; }, "baseline: tip.x",
     "failed", "not a number at 0.5 s"},
    {"what is not a number in both, and equal after it",
     [](Document& before, Document& now) {
       values_of(before, "tip.x")[1] = values_of(now, "tip.x")[1] = nullptr;
     },
     "baseline: tip.x", "failed", "not a number at 0.5 s"},
    {"no column and no picture",
     [](Document& before, Document& now) {
       for (Document* one : {&before, &now})
         for (const char* column : {"tip.x", "tip.y", "tip.z"}) (*one)["probes"].erase(column);
     },
     "baseline", "not run", "there was nothing to compare"},
    {"a criterion that is gone", [](Document&, Document& now) { now["verdicts"].erase(0); },
     "baseline: verdicts", "failed", "no longer: known: tip.y"},
    {"a criterion that allows more than it did",
     [](Document&, Document& now) { now["verdicts"][0]["limit"] = 1e9; }, "baseline: verdicts", "failed",
     "no longer: known: tip.y"},
    {"a criterion that allows less than it did",
     [](Document&, Document& now) { now["verdicts"][0]["limit"] = 0.11; }, "baseline: verdicts", "passed",
     ""},
};

class Changed : public ::testing::TestWithParam<ChangedBaseline> {};

TEST_P(Changed, IsNeverNoMove) {
  const ChangedBaseline& row = GetParam();
  Document before = document_with(0), document = before;
  row.change(before, document);
  hold_against_baseline(document, before, "first", default_regression_share);
  const Json verdict = verdict_named(document, row.verdict);
  ASSERT_TRUE(verdict.is_object()) << row.sentence << ": no verdict " << row.verdict;
  EXPECT_EQ(verdict.at("status"), row.status) << row.sentence << ": " << verdict;
  EXPECT_NE(verdict.at("message").get<std::string>().find(row.says), std::string::npos)
      << row.sentence << ": " << verdict;
  const bool same = std::string(row.status) == "passed";
  EXPECT_EQ(document.at("all_criteria_met").get<bool>(), same) << row.sentence;
  EXPECT_EQ(
      document.at("headline").get<std::string>().find("Nothing that was compared moved") != std::string::npos,
      same)
      << row.sentence << ": " << document.at("headline");
}

INSTANTIATE_TEST_SUITE_P(Baseline, Changed, ::testing::ValuesIn(changed_baselines),
                         [](const auto& row) { return as_name(row.param.sentence); });

/// What makes a baseline one of another case.
struct OtherCase {
  const char* sentence;
  void (*change)(Document& of_the_case);
  const char* says;
};

const OtherCase other_cases[] = {
    {"another gravity", [](Document& c) { c["loads"]["gravity"][1] = -9.81; },
     "loads.gravity is [0.0,-9.81,0.0] there and "},
    {"one more element", [](Document& c) { c["cable"]["elements"] = 2; },
     "cable.elements is 2 there and 1 here"},
    {"another end", [](Document& c) { c["time"]["end"] = 2.0; }, "time.end is 2 there and 1 here"},
    {"an end that differs in the twelfth digit", [](Document& c) { c["time"]["end"] = 1.00000000001; },
     "time.end is 1.00000000001 there and 1.0 here"},
    {"an end that is a text", [](Document& c) { c["time"]["end"] = "1"; },
     "time.end is 1 there and 1.0 here"},
    {"another output interval", [](Document& c) { c["time"]["output_interval"] = 0.25; },
     "time.output_interval"},
    {"another step", [](Document& c) { c["method"]["step"] = 0.2; }, "method.step is 0.2 there and 0.1 here"},
    {"another method", [](Document& c) { c["method"]["name"] = "bdf"; },
     "method.name is bdf there and rk4 here"},
    {"another support", [](Document& c) { c["supports"]["first"] = "clamped"; }, "supports.first is clamped"},
    {"another start", [](Document& c) { c["start"]["axial_speed"] = 1.0; }, "start.axial_speed"},
    {"another place of a probe", [](Document& c) { c["probes"][0]["at"] = 0.5; },
     "probes.0.at is 0.5 there and 1 here"},
    {"no probes", [](Document& c) { c["probes"] = Document::array(); }, "probes is [] there and"},
    {"a key that is not there", [](Document& c) { c["cable"].erase("density"); },
     "cable.density is – there and 1000 here"},
    {"a key that is not here", [](Document& c) { c["loads"]["wind"] = 3; },
     "loads.wind is 3 there and – here"},
    {"a number that is not finite", [](Document& c) { c["cable"]["area"] = nullptr; },
     "cable.area is not finite there"},
    {"more than can be listed",
     [](Document& c) {
       c["cable"] = {{"length", 3}};
     },
     ", and 5 keys more"},
};

class OfAnotherCase : public ::testing::TestWithParam<OtherCase> {};

TEST_P(OfAnotherCase, IsRefusedWithWhatDiffers) {
  const OtherCase& row = GetParam();
  Document before = document_with(0), document = before;
  row.change(before["case"]);
  try {
    hold_against_baseline(document, before, "first", default_regression_share);
    FAIL() << row.sentence << " is taken for the same case";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("first: the baseline is of another case: ")) << message;
    EXPECT_NE(message.find(row.says), std::string::npos) << row.sentence << ": " << message;
    EXPECT_LT(message.size(), 600U) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(Baseline, OfAnotherCase, ::testing::ValuesIn(other_cases),
                         [](const auto& row) { return as_name(row.param.sentence); });

TEST(Regression, WhereACaseLiesAndWhatItIsRunOnMakeItNoOther) {
  Document before = document_with(0), document = before;
  before["case"]["file"] = "elsewhere/of_another_name.toml";
  before["case"]["text"] = "# a remark\n";
  before["provenance"]["compiler"] = "another";
  before["renderer"] = "another";
  before["title"] = "another";
  before.erase("check_sum");
  hold_against_baseline(document, before, "first", default_regression_share);
  EXPECT_TRUE(document.at("all_criteria_met")) << document.at("headline");
}

TEST(Regression, APictureThatEitherLacksOrThatLooksOtherwiseHasMoved) {
  const TemporaryFolder folder;
  const auto picture = [](const std::string& file, std::uint8_t grey) {
    const Image image{20, 20, std::vector<std::uint8_t>(3 * 20 * 20, grey)};
    Picture made;
    made.file = file;
    made.png = encode_png(image);
    return made;
  };
  const Picture same = picture("figures/same.png", 100), other = picture("figures/other.png", 200),
                damaged = picture("figures/damaged.png", 50);
  Document before = document_with(0);
  for (const char* name : {"same", "other", "damaged", "gone", "no_file"})
    before["figures"].push_back({{"file", fmt::format("figures/{}.png", name)}});
  write_text(folder / "figures/same.png", same.png);
  write_text(folder / "figures/other.png", picture("figures/other.png", 20).png);
  write_text(folder / "figures/damaged.png", "no picture");
  const auto moves =
      picture_moves(before, folder.path().string(),
                    {same, other, damaged, picture("figures/no_file.png", 1), picture("figures/new.png", 1)});
  std::map<std::string, std::string> moved;
  for (const PictureMove& move : moves) {
    if (move.moved)
      moved[move.file] = move.in_words;
    else
      EXPECT_EQ(move.file, "figures/same.png") << move.in_words;
  }
  EXPECT_EQ(moves.size(), 6U);
  EXPECT_EQ(moved.size(), 5U);
  EXPECT_NE(moved["figures/other.png"].find("400 pixels differ"), std::string::npos)
      << moved["figures/other.png"];
  EXPECT_EQ(moved["figures/gone.png"], "this run has no such picture");
  EXPECT_EQ(moved["figures/new.png"], "the earlier report has no such picture");
  EXPECT_NE(moved["figures/no_file.png"].find("No such file"), std::string::npos)
      << moved["figures/no_file.png"];

  Document document = document_with(0);
  hold_against_baseline(document, document_with(0), "first", default_regression_share, moves);
  EXPECT_EQ(verdict_named(document, "baseline: figures/same.png").at("status"), "passed");
  EXPECT_EQ(verdict_named(document, "baseline: figures/gone.png").at("status"), "failed");
  EXPECT_FALSE(document.at("all_criteria_met"));
}

TEST(Regression, APictureOutsideOfTheBaselineIsNotRead) {
  const TemporaryFolder folder;
  for (const char* file : {"/etc/hostname", "../figures/a.png", "figures/../../a.png", ""}) {
    Document before = document_with(0);
    before["figures"].push_back({{"file", file}});
    Picture now;
    now.file = file;
    const auto moves = picture_moves(before, folder.path().string(), {now});
    ASSERT_EQ(moves.size(), 1U);
    EXPECT_TRUE(moves[0].moved) << file;
    EXPECT_EQ(moves[0].in_words, "it is not within the folder of the earlier report") << file;
  }
}

/// What another rounding may do to each column: as much from the start on, or much from output `from` on.
ProbeTable reach_of(const Document& document, double share, std::size_t from = 1000) {
  ProbeTable reach;
  for (const auto& [name, column] : document.at("probes").items()) {
    if (name == "t") continue;
    double largest = 0;
    for (const Json& value : column.at("values")) largest = std::max(largest, std::abs(value.get<double>()));
    Column one{name, "m", {}};
    for (std::size_t k = 0; k < column.at("values").size(); ++k)
      one.values.push_back(k < from ? share * largest : largest);
    reach.columns.push_back(one);
  }
  return reach;
}

TEST(Regression, ABaselineOfAnotherCompilerMayMoveByWhatARoundingDoes) {
  Document before = document_with(0);
  before["provenance"]["compiler"] = "another 1.0";
  for (const auto& [share, status] : {std::pair{2e-3, "passed"}, {1e-6, "failed"}}) {
    Document document = document_with(1e-3);
    hold_against_baseline(document, before, "first", default_regression_share, {}, reach_of(before, share));
    const Json verdict = verdict_named(document, "baseline: tip.x");
    EXPECT_EQ(verdict.at("status"), status) << verdict;
    EXPECT_NE(verdict.at("message").get<std::string>().find("made with another compiler"), std::string::npos)
        << verdict;
  }
}

TEST(Regression, PastTheHorizonNothingIsComparableAndNothingRegressed) {
  Document before = document_with(0);
  before["provenance"]["processor"] = "another";
  Document document = document_with(0);
  Json& values = document["probes"]["tip.x"]["values"];
  const std::size_t last = values.size() - 1;
  values[last] = values[last].get<double>() + 0.5;
  const PictureMove picture{"figures/a.png", true, 0.5, "differs"};
  hold_against_baseline(document, before, "first", default_regression_share, {picture},
                        reach_of(before, 1e-9, last));
  const Json verdict = verdict_named(document, "baseline: tip.x");
  EXPECT_EQ(verdict.at("status"), "passed") << verdict;
  EXPECT_NE(verdict.at("message").get<std::string>().find("not comparable here from"), std::string::npos)
      << verdict;
  const std::string not_compared = document.at("baseline").at("not_compared").dump();
  EXPECT_NE(not_compared.find("tip.x from"), std::string::npos) << not_compared;
  EXPECT_NE(not_compared.find("figures/a.png"), std::string::npos) << not_compared;
  EXPECT_NE(document.at("headline").get<std::string>().find("Not compared: tip.x from"), std::string::npos)
      << document.at("headline");
  // Before the horizon a move is one.
  values[last - 1] = values[last - 1].get<double>() + 0.5;
  document["verdicts"] = Json::array();
  hold_against_baseline(document, before, "first", default_regression_share, {},
                        reach_of(before, 1e-9, last));
  EXPECT_EQ(verdict_named(document, "baseline: tip.x").at("status"), "failed");
}

TEST(Regression, ABaselineWithoutPicturesSaysThatNoneWereCompared) {
  Document document = document_with(0);
  hold_against_baseline(document, document_with(0), "first", default_regression_share);
  EXPECT_NE(document.at("headline").get<std::string>().find("Not compared: pictures"), std::string::npos)
      << document.at("headline");
}

TEST(Regression, OnlyWhatRoundsIsAnotherMachine) {
  const Document now = document_with(0);
  Document before = now;
  before["provenance"]["made at"] = "earlier";
  before["provenance"]["revision"] = "another";
  EXPECT_EQ(rounds_otherwise(before, now), "");
  before["provenance"]["compiler"] = "another";
  before["provenance"]["system"] = "another";
  EXPECT_EQ(rounds_otherwise(before, now), "compiler, system");
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

TEST(Regression, EveryVerdictThatPassedIsLookedForAndNoOther) {
  Document before = document_with(0);
  const Document one = before["verdicts"][0];
  ASSERT_EQ(one["status"], "passed");
  const auto add = [&](Document& document, const char* name, const char* status, const char* kind) {
    document["verdicts"].push_back(one);
    document["verdicts"].back()["name"] = name;
    document["verdicts"].back()["status"] = status;
    document["verdicts"].back()["kind"] = kind;
  };
  add(before, "never met", "failed", "validation");
  add(before, "baseline: gone.x", "passed", "regression");
  Document now = before;
  now["verdicts"].erase(2);
  add(before, "last", "passed", "validation");
  const auto verdict = [&](Document document) {
    hold_against_baseline(document, before, "first", default_regression_share);
    return verdict_named(document, "baseline: verdicts");
  };
  const Json gone = verdict(now);
  EXPECT_EQ(gone.at("value"), 1) << gone;
  EXPECT_EQ(gone.at("message"), "no longer: last");
  add(now, "last", "passed", "validation");
  EXPECT_EQ(verdict(now).at("value"), 0) << verdict(now);
  before["verdicts"].erase(3);
  before["verdicts"].erase(0);
  EXPECT_TRUE(verdict(now).is_null()) << "nothing passed that could be kept: " << verdict(now);
}

TEST(Regression, LongTextsOfAnotherCaseAreCutBetweenLetters) {
  const auto told = [](const std::string& text) -> std::string {
    const Document other = {{"case", {{"note", text}}}}, own = {{"note", "n"}};
    try {
      refuse_other_case(other, "first", own);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto words = [](const std::string& text) {
    return "first: the baseline is of another case: note is " + text + " there and n here";
  };
  const std::string long_one = "b" + std::string(58, 'a');
  EXPECT_EQ(told(long_one + "z"), words(long_one + "z")) << "60 are not too many";
  EXPECT_EQ(told(long_one + "zz"), words(long_one + "z…"));
  EXPECT_EQ(told(long_one + "éz"), words(long_one + "…")) << "half a letter is none";
}

TEST(Regression, AVerdictThatClaimsLessThanItDidIsNamed) {
  const Document before = document_with(0);
  ASSERT_EQ(before["verdicts"][0]["status"], "passed");
  const auto value = [&](const std::function<void(Document&)>& change) {
    Document document = before;
    change(document["verdicts"][0]);
    hold_against_baseline(document, before, "first", default_regression_share);
    return verdict_named(document, "baseline: verdicts").at("value").get<double>();
  };
  EXPECT_EQ(value([](Document&) {}), 0);
  EXPECT_EQ(value([](Document& v) { v["criterion"] = "rms of something else"; }), 1);
  EXPECT_EQ(value([](Document& v) { v["limit"] = v["limit"].get<double>() * 2; }), 1);
  EXPECT_EQ(value([](Document& v) { v["coverage"]["demanded"] = v["coverage"]["demanded"].get<long>() - 1; }),
            1);
  EXPECT_EQ(value([](Document& v) { v["coverage"]["allowance"] = "no more than to 1 s"; }), 1);
}

class Baseline : public ::testing::Test {
 protected:
  Ended run(const std::string& into, const std::vector<std::string>& more = {}) {
    // Small pictures, as they are not looked at here.
    std::vector<std::string> arguments{"run",   small_case(),         "-o",    into,
                                       "--set", "scene.frame_rate=1", "--set", "scene.size=[64,48]"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return plumb_in(folder_.path(), arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(Baseline, RunThatMovedFailsWithHowFar) {
  run("first");
  Json earlier = results_in(folder_ / "first");
  Json& value = earlier["probes"]["mid.y"]["values"][1];
  value = value.get<double>() + 1e-3;
  write_text(folder_ / "first/results.json", earlier.dump());
  fs::remove(folder_ / "first/figures/energy.png");
  const Ended ended = run("moved", {"--baseline", "first"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  const Json results = results_in(folder_ / "moved");
  const Json verdict = verdict_named(results, "baseline: mid.y");
  EXPECT_EQ(verdict.at("status"), "failed") << verdict;
  EXPECT_GT(verdict.at("value").get<double>(), 1e-4) << verdict;
  EXPECT_EQ(verdict_named(results, "baseline: figures/energy.png").at("status"), "failed")
      << "a picture that is not there";
  EXPECT_EQ(verdict_named(results, "baseline: check sum").at("status"), "failed") << "it was changed";
  EXPECT_FALSE(results.at("all_criteria_met"));
  EXPECT_NE(read_text(folder_ / "moved/junit.xml").find("<testsuite name=\"regression\""), std::string::npos);
  EXPECT_NE(read_text(folder_ / "moved/index.html").find("What changed"), std::string::npos);
}

TEST_F(Baseline, OfTheSameCaseIsMetWithItsPicturesOrAsNumbersAlone) {
  run("first");
  const Ended again = run("again", {"--baseline", "first"});
  EXPECT_NE(again.out.find("Nothing moved since the baseline."), std::string::npos) << again.out << again.err;
  EXPECT_EQ(verdict_named(results_in(folder_ / "again"), "baseline: figures/energy.png").at("status"),
            "passed");
  write_text(folder_ / "kept/results.json", read_text(folder_ / "first/results.json"));
  const Ended numbers = run("again", {"--baseline", "kept/results.json"});
  EXPECT_NE(numbers.out.find("Nothing that was compared moved since the baseline."), std::string::npos)
      << numbers.out;
}

TEST_F(Baseline, ThatWasChangedVouchesForNothingUnlessItSaysThatItWas) {
  run("first");
  Json earlier = results_in(folder_ / "first");
  earlier["verdicts"] = Json::array();
  write_text(folder_ / "kept/results.json", earlier.dump());
  const Ended changed = run("again", {"--baseline", "kept/results.json"});
  EXPECT_EQ(changed.status, 1) << changed.out << changed.err;
  EXPECT_EQ(changed.out.find("moved since the baseline"), std::string::npos) << changed.out;
  EXPECT_NE(changed.out.find("it was changed after it was written; without its key check_sum"),
            std::string::npos)
      << changed.out;
  earlier.erase("check_sum");
  write_text(folder_ / "kept/results.json", earlier.dump());
  const Ended said = run("again", {"--baseline", "kept/results.json"});
  EXPECT_NE(said.out.find("Nothing that was compared moved since the baseline."), std::string::npos)
      << said.out << said.err;
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
  run("first");
  Json damaged = results_in(folder_ / "first");
  damaged["probes"]["mid.y"]["values"] = "none";
  write_text(folder_ / "damaged.json", damaged.dump());
  refused("damaged.json", "damaged.json");
  for (const char* change : {"loads.gravity=[0,-9.8,0]", "cable.elements=5", "time.end=1"}) {
    const Ended other = run("new", {"--baseline", "first", "--set", change});
    EXPECT_EQ(other.status, 3) << change << other.err;
    EXPECT_NE(other.err.find("the baseline is of another case: "), std::string::npos) << other.err;
    EXPECT_FALSE(fs::exists(folder_ / "new")) << change;
  }
  EXPECT_EQ(run("new", {"--baseline", "first", "--numbers", "inf"}).status, 2) << "it would allow anything";
  EXPECT_EQ(run("new", {"--baseline", "first", "--numbers", "nan"}).status, 2);
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

}  // namespace baseline_test
}  // namespace plumb
