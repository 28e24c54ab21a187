#include "report/verdict/coverage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/document/case_json.h"
#include "report/document/document.h"
#include "report/page/page.h"
#include "report/verdict/results.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace coverage_test {

using Motion = std::function<double(double)>;

double line(double t) {
  return 1 + t;
}

std::vector<double> every(double interval, int count) {
  std::vector<double> times;
  for (int k = 0; k < count; ++k) times.push_back(k * interval);
  return times;
}

/// The rows of a file whose tip.x is a motion at some times.
std::string rows(const std::vector<double>& times, const Motion& x = line) {
  std::string text = "t,tip.x\n";
  for (const double t : times) text += fmt::format("{:.17g},{:.17g}\n", t, x(t));
  return text;
}

/// A case without [method] on one run, held against x = 1 + t at 0, 0.5, 1, 1.5 and 2 s to 0.01 m.
struct Given {
  std::string run = rows(every(0.1, 21));
  std::string run_keys = "", reference_keys = "", extra = "";
  std::string reference_rows = "[0, 1], [0.5, 1.5], [1, 2], [1.5, 2.5], [2, 3]";
  std::string other = "";  ///< a second run, "h"
  std::string other_keys = "";
  std::vector<std::string> overrides = {};

  plumb::Run reported() const {
    CaseSource source;
    source.file = {"case.toml",
                   fmt::format(R"(title = "Given"
[[run]]
file = "g.csv"
{}
{}
[cable]
length = 1
area = 1e-6
density = 1000
youngs_modulus = 1e6
[[probe]]
name = "tip"
at = 1.0
[[reference]]
file = "known.toml"
compare = {{ x = "tip.x" }}
tolerance = 0.01
{}
{})",
                               run_keys, other.empty() ? "" : "[[run]]\nfile = \"h.csv\"\n" + other_keys,
                               reference_keys, extra)};
    source.references = {
        MadeReference{.rows = reference_rows, .kind = "computed", .series = "x", .uncertainty = 0.001}
            .text()};
    source.given_runs = {{"g.csv", run}};
    if (!other.empty()) source.given_runs.push_back({"h.csv", other});
    source.overrides = overrides;
    return reported_run(load_case(source), {});
  }
};

struct Judged {
  VerdictStatus status;
  double value;
  std::string message;
  Outcome outcome;
  bool all_met;
  Coverage coverage;
};

Judged judged(const Given& given, std::size_t verdict = 0) {
  const plumb::Run run = given.reported();
  const Results results = evaluate(run, {});
  const Verdict& one = results.verdicts.at(verdict);
  return {one.status,
          one.value,
          one.message,
          results.outcome,
          document_of(results, {}).at("all_criteria_met").get<bool>(),
          one.coverage.value()};
}

TEST(Coverage, OfAGoodRunIsAllOfTheReferenceAndIsSaidInNumbers) {
  const Judged good = judged({.run = rows(every(0.125, 17))});
  EXPECT_EQ(good.status, VerdictStatus::passed) << good.message;
  EXPECT_EQ(good.outcome, Outcome::accurate);
  EXPECT_TRUE(good.all_met);
  EXPECT_EQ(
      good.message,
      "0 m of 0.01 m allowed, the greatest at 0 s; over 5 of 5 times from 0 to 2 s, outputs at most 0.125 s "
      "apart");
  EXPECT_EQ(good.coverage.demanded, 5U);
  EXPECT_EQ(good.coverage.compared, 5U);
  EXPECT_EQ(good.coverage.interpolated, 0U);
  EXPECT_EQ(good.coverage.longest_gap, 0.125);
}

/// A vibration of 2 s about 1 m, of which something is read off.
Given read_off(const std::string& quantity, const std::string& reference_rows, double interval = 0.05) {
  return {.run = rows(every(interval, static_cast<int>(5 / interval) + 1),
                      [](double t) { return 1 + std::cos(3.14159265358979 * t); }),
          .reference_rows = reference_rows,
          .overrides = {"reference.0.compare={ x = \"" + quantity + "\" }"}};
}

TEST(Coverage, OfWhatIsReadOffAColumnIsUpToEachTimeOfTheReference) {
  const Judged greatest = judged(read_off("greatest tip.x", "[3.1, 2], [4.9, 2]"));
  EXPECT_EQ(greatest.status, VerdictStatus::passed) << greatest.message;
  const Judged least = judged(read_off("least tip.x", "[0.5, 1], [2, 0]"));
  EXPECT_EQ(least.status, VerdictStatus::passed) << least.message;
  EXPECT_LT(least.value, 1e-4) << "0.5 s is before the least of all";
}

TEST(Coverage, OfWhatIsReadOffAColumnNeedsOutputsThatBearIt) {
  const Judged coarse = judged(read_off("greatest tip.x", "[4.9, 2]", 0.35));
  EXPECT_EQ(coarse.status, VerdictStatus::not_run) << coarse.message;
  EXPECT_NE(coarse.message.find("where every second output is left out, more than 10 % of the tolerance"),
            std::string::npos)
      << coarse.message;
  const Judged few = judged(read_off("greatest tip.x", "[0.3, 2]"));
  EXPECT_NE(few.message.find("greatest tip.x of g: 7 outputs up to 0.3 s are too few"), std::string::npos)
      << few.message;
}

TEST(Coverage, TooLittleOfARunIsNotRunAndSaysWhy) {
  std::vector<double> hole{0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 1.6, 1.7, 1.8, 1.9, 2};
  std::vector<double> late = every(0.1, 21), alternating;
  late.erase(late.begin(), late.begin() + 2);
  for (int k = 0; k < 10; ++k) {
    alternating.push_back(k * 0.21);
    alternating.push_back(k * 0.21 + 0.01);
  }
  const struct {
    const char* what;
    Given given;
    const char* why;
  } examples[] = {
      {"too short",
       {.run = rows({0, 0.1}, [](double t) { return 1 + 90 * t; })},
       "only 1 of 5 times of the reference can be compared: g does not have t = 0.5 s: it is from 0 to 0.1 "
       "s"},
      {"one row",
       {.run = "t,tip.x\n2.0,3.0\n"},
       "only 1 of 5 times of the reference can be compared: g does not have t = 0 s: it is from 2 to 2 s"},
      {"wrong unit",
       {.run_keys = "units = { t = \"us\" }"},
       "it is from 0 to 2e-06 s, and nothing is extrapolated"},
      {"the end of the case is no excuse",
       {.run = rows({0, 0.1}), .extra = "[time]\nend = 0.1\n"},
       "only 1 of 5 times"},
      {"nor is a very late end",
       {.run = rows({0, 1, 2}), .extra = "[time]\nend = 1e6\n[scene]\nframe_rate = 0.02\n"},
       "g has no output within 0.25 s of t = 0.5 s"},
      {"two rows",
       {.run = rows({0, 2})},
       "only 2 of 5 times of the reference can be compared: g has no output within 0.25 s of t = 0.5 s, and "
       "2 "
       "outputs are too few"},
      {"three rows", {.run = rows({0, 1, 2})}, "g has no output within 0.25 s of t = 0.5 s"},
      {"a distant last row",
       {.run = rows({0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 1e12}), .extra = "[time]\nend = 2\n"},
       "g has no output within 0.1 s of t = 1 s, and interpolation was not tried as far as 0.2 s"},
      {"a hole",
       {.run = rows(hole)},
       "only 4 of 5 times of the reference can be compared: g has no output within 0.1 s of t = 1 s, and "
       "interpolation was not tried as far as 0.2 s"},
      {"pairs of rows", {.run = rows(alternating)}, "g has no output within 0.01 s of t = 0.5 s"},
      {"starts late", {.run = rows(late)}, "g does not have t = 0 s: it is from 0.2 to 2 s"},
      {"a motion too fast for its rows",
       {.run = rows(every(0.15, 15), [](double t) { return 1 + t + std::sin(20 * t); })},
       "more than 10 % of the tolerance"},
      {"what is the start but for rounding",
       {.run = rows(every(0.1, 21)), .reference_rows = "[0, 1], [1e-12, 1]"},
       "no time of the reference after t = 0 can be compared"},
      {"nothing but the start", {.reference_rows = "[0, 1]"}, "the reference has no time after t = 0"},
      {"a reference after the end", {.reference_rows = "[3, 4], [4, 5]"}, "only 0 of 2 times"},
      {"a share that leaves the start alone",
       {.run = rows({0, 0.1}), .reference_keys = "coverage = { share = 0.01 }"},
       "no time of the reference after t = 0 can be compared"},
  };
  for (const auto& [what, given, why] : examples) {
    const Judged found = judged(given);
    EXPECT_EQ(found.status, VerdictStatus::not_run) << what << ": " << found.message;
    EXPECT_NE(found.message.find(why), std::string::npos) << what << ": " << found.message;
    EXPECT_EQ(found.outcome, Outcome::completed) << what;
    EXPECT_FALSE(found.all_met) << what;
    EXPECT_FALSE(found.coverage.enough()) << what;
  }
}

TEST(Coverage, AGapThatInterpolationBearsIsInterpolatedAndSaysHowWell) {
  const Motion quartic = [](double t) { return 1 + t + 0.01 * t * t * t * t; };
  const Judged found =
      judged({.run = rows(every(0.15625, 14), quartic), .reference_rows = "[0, 1], [1, 2.01]"});
  EXPECT_EQ(found.status, VerdictStatus::passed) << found.message;
  EXPECT_LT(found.value, found.coverage.interpolation_error);
  EXPECT_EQ(found.coverage.interpolated, 1U);
  EXPECT_NEAR(found.coverage.interpolation_error, 0.01 * 9 * std::pow(0.15625, 4), 1e-15)
      << "h · h · 3h · 3h";
  EXPECT_NE(
      found.message.find("1 of them interpolated, which may be 5.4e-05 m off (every second output left out)"),
      std::string::npos)
      << found.message;
}

TEST(Coverage, OneMissingRowIsBorneAndTwoAreNot) {
  std::vector<double> one = every(0.125, 17), two = every(0.125, 17);
  one.erase(one.begin() + 8);
  two.erase(two.begin() + 8, two.begin() + 10);
  EXPECT_EQ(judged({.run = rows(one)}).status, VerdictStatus::passed) << judged({.run = rows(one)}).message;
  EXPECT_EQ(judged({.run = rows(one)}).coverage.longest_gap, 0.25);
  const Given past_the_middle{.run = rows(two), .reference_rows = "[0, 1], [1.0625, 2.0625], [2, 3]"};
  EXPECT_EQ(judged(past_the_middle).status, VerdictStatus::not_run) << judged(past_the_middle).message;
}

TEST(Coverage, GapsAreThoseWithinWhatIsClaimed) {
  const std::vector<double> late{0, 0.25, 0.5, 0.75, 1, 2}, early{0, 1, 1.25, 1.5, 1.75, 2};
  const Judged first = judged({.run = rows(late), .reference_keys = "coverage = { to = 1 }"});
  EXPECT_EQ(first.status, VerdictStatus::passed) << first.message;
  EXPECT_EQ(first.coverage.longest_gap, 0.25) << first.message;
  const Judged last = judged({.run = rows(early), .reference_keys = "coverage = { from = 1 }"});
  EXPECT_EQ(last.status, VerdictStatus::passed) << last.message;
  EXPECT_EQ(last.coverage.longest_gap, 0.25) << last.message;
}

TEST(Coverage, ACaseMayClaimLessAndTheVerdictSaysSo) {
  const struct {
    const char* keys;
    VerdictStatus status;
    std::size_t compared, demanded;
    const char* words;
  } examples[] = {
      {"coverage = { to = 1 }", VerdictStatus::passed, 3, 3, "the case claims no more than to 1 s"},
      {"coverage = { from = 0.5, to = 1 }", VerdictStatus::passed, 2, 2,
       "the case claims no more than from 0.5 s to 1 s"},
      {"coverage = { share = 0.6 }", VerdictStatus::passed, 3, 5,
       "the case claims no more than 60 % of the times"},
      {"coverage = { to = 1.5, share = 0.75 }", VerdictStatus::passed, 3, 4,
       "the case claims no more than to 1.5 s and 75 % of the times there"},
      {"coverage = { share = 0.61 }", VerdictStatus::not_run, 3, 5, "61 % of the times"},
      {"coverage = { to = 1.5 }", VerdictStatus::not_run, 3, 4, "only 3 of 4 times"},
      {"coverage = { from = 1.5 }", VerdictStatus::not_run, 0, 2, "only 0 of 2 times"},
      {"coverage = {}", VerdictStatus::not_run, 3, 5, "only 3 of 5 times"},
  };
  for (const auto& [keys, status, compared, demanded, words] : examples) {
    const Judged found = judged({.run = rows(every(0.125, 9)), .reference_keys = keys});
    EXPECT_EQ(found.status, status) << keys << ": " << found.message;
    EXPECT_EQ(found.coverage.compared, compared) << keys;
    EXPECT_EQ(found.coverage.demanded, demanded) << keys;
    EXPECT_NE(found.message.find(words), std::string::npos) << keys << ": " << found.message;
  }
}

TEST(Coverage, OnlyWhatIsClaimedIsJudged) {
  const Motion late_error = [](double t) { return t > 1.05 ? 9.0 : 1 + t; };
  EXPECT_EQ(judged({.run = rows(every(0.125, 17), late_error)}).status, VerdictStatus::failed);
  EXPECT_EQ(
      judged({.run = rows(every(0.125, 17), late_error), .reference_keys = "coverage = { to = 1 }"}).status,
      VerdictStatus::passed);
}

TEST(Coverage, OfARunOfPlumbsOwnIsNotLessForAnEarlierEndOrRarerOutputs) {
  plumb::Run run = run_with("a");
  EXPECT_EQ(verdicts(run, series_errors(run))[0].status, VerdictStatus::passed);
  plumb::Run early = run;
  early.loaded.spec.time.end = early.trajectory.end_time = 0.5;
  early.trajectory.times.pop_back();
  const Verdict short_one = verdicts(early, series_errors(early))[0];
  EXPECT_EQ(short_one.status, VerdictStatus::not_run);
  EXPECT_NE(short_one.message.find(
                "only 2 of 3 times of the reference can be compared: Plumb does not have t = 1 s"),
            std::string::npos)
      << short_one.message;
  plumb::Run rare = run;
  for (auto* list : {&rare.trajectory.q, &rare.trajectory.v}) list->erase(list->begin() + 1);
  rare.trajectory.times = {0, 1};
  const Verdict rare_one = verdicts(rare, series_errors(rare))[0];
  EXPECT_EQ(rare_one.status, VerdictStatus::not_run);
  EXPECT_NE(
      rare_one.message.find("Plumb has no output within 0.25 s of t = 0.5 s, and 2 outputs are too few"),
      std::string::npos)
      << rare_one.message;
}

TEST(DistanceNorms, OfNoDifferenceAreZero) {
  const DifferenceNorms norms = norms_of({0, 1}, {0, 0});
  EXPECT_EQ(norms.max, 0);
  EXPECT_EQ(norms.rms, 0);
}

TEST(DistanceCoverage, IsOfTheTimesOfBothRuns) {
  const Motion bump = [](double t) { return 1 + t + (t > 0.05 && t < 1.95 ? 50 : 0); };
  std::vector<double> half = every(0.125, 17);
  half.resize(9);
  const Motion near = [](double t) { return 1 + t + 1e-6; };
  const std::string tolerances = "tolerances = { \"tip.x\" = 0.01 }\n";
  const struct {
    const char* what;
    Given given;
    VerdictStatus status;
    const char* words;
  } examples[] = {
      {"the same motion at other times",
       {.other = rows(every(0.1, 21))},
       VerdictStatus::passed,
       "over 33 of 33 times from 0 to 2 s, outputs at most 0.125 s apart; 28 of them interpolated"},
      {"one row",
       {.other = "t,tip.x\n2.0,3.0\n"},
       VerdictStatus::not_run,
       "only 1 of 17 times of the two runs can be compared: h does not have t = 0 s"},
      {"a row at either end, 50 m between",
       {.run = rows(every(0.125, 17), bump), .other = rows({0, 2})},
       VerdictStatus::not_run,
       "h has no output within"},
      {"a row at either end of the one that is reported",
       {.run = rows({0, 2}), .other = rows(every(0.125, 17))},
       VerdictStatus::not_run,
       "g has no output within"},
      {"the start alone, which is a moment later in one",
       {.other = rows({1e-11, 2.5}), .other_keys = "coverage = { share = 0.01 }\n"},
       VerdictStatus::not_run,
       "no time of the two runs after t = 0 can be compared"},
      {"no overlap", {.other = rows({5, 6, 7})}, VerdictStatus::not_run, "only 0 of 20 times"},
      {"half of it", {.other = rows(half)}, VerdictStatus::not_run, "only 9 of 17 times"},
      {"longer than what is reported",
       {.other = rows(every(0.125, 25))},
       VerdictStatus::not_run,
       "only 17 of 25 times of the two runs can be compared: g does not have t = 2.125 s"},
      {"half of it, as is claimed",
       {.other = rows(half, near), .other_keys = "coverage = { to = 1 }\n"},
       VerdictStatus::passed,
       "over 9 of 9 times from 0 to 1 s, outputs at most 0.125 s apart; the case claims no "
       "more than to 1 s"},
      {"far at one row of its own only",
       {.other = rows(every(0.1, 21), [](double t) { return t > 0.25 && t < 0.35 ? 1.5 : 1 + t; })},
       VerdictStatus::not_run,
       "more than 10 % of the tolerance"},
  };
  for (auto [what, given, status, words] : examples) {
    if (given.run == rows(every(0.1, 21))) given.run = rows(every(0.125, 17));
    given.other_keys = tolerances + given.other_keys;
    const plumb::Run run = given.reported();
    const Results results = evaluate(run, {});
    const Verdict& verdict = results.verdicts.at(2);
    EXPECT_EQ(verdict.name, "h: g: tip.x");
    EXPECT_EQ(verdict.status, status) << what << ": " << verdict.message;
    EXPECT_NE(verdict.message.find(words), std::string::npos) << what << ": " << verdict.message;
    ASSERT_TRUE(verdict.coverage) << what;
    EXPECT_EQ(results.distances.at(0).coverage.compared, verdict.coverage->compared);
    EXPECT_EQ(results.distances.at(0).times.size(), verdict.coverage->compared);
    EXPECT_EQ(results.outcome == Outcome::accurate, all_passed(results.verdicts)) << what;
  }
}

TEST(Outcome, IsAccurateOnlyWithEveryVerdictOfEveryRun) {
  const auto outcome = [](const Given& given) {
    const plumb::Run run = given.reported();
    const Results results = evaluate(run, {});
    return std::pair{results.outcome, headline(results)};
  };
  EXPECT_EQ(outcome({.other = rows(every(0.1, 21))}).first, Outcome::accurate);
  const auto [not_run, words] = outcome({.other = rows({0, 2})});
  EXPECT_EQ(not_run, Outcome::completed);
  EXPECT_NE(words.find("Completed, but h: known: tip.x is not run. Of 2 criteria, 0 not met and 1 not run"),
            std::string::npos)
      << words;
  const auto [wrong, wrong_words] = outcome({.other = rows(every(0.1, 21), [](double) { return 7.0; })});
  EXPECT_EQ(wrong, Outcome::completed) << "the run that is reported is not the one that is wrong";
  EXPECT_NE(wrong_words.find("Completed, but h: known: tip.x is not met. 1 of 2 criteria not met"),
            std::string::npos)
      << wrong_words;
  EXPECT_EQ(wrong_words.find("Accurate"), std::string::npos);
  const auto [far, far_words] = outcome({.other = rows(every(0.1, 21), [](double t) { return 1.005 + t; }),
                                         .other_keys = "tolerances = { \"tip.x\" = 0.001 }\n"});
  EXPECT_EQ(far, Outcome::completed) << "both are near the reference, and not each other: " << far_words;
}

TEST(Outcome, WithoutACriterionNothingIsMet) {
  const plumb::Run run = Given{.overrides = {"reference=[]"}}.reported();
  const Results results = evaluate(run, {});
  EXPECT_TRUE(results.verdicts.empty());
  EXPECT_EQ(results.outcome, Outcome::completed);
  const Document document = document_of(results, {});
  EXPECT_FALSE(document.at("all_criteria_met").get<bool>());
  EXPECT_EQ(document.at("headline").get<std::string>(),
            "Completed, but not held against anything. The case names no criterion, so nothing is claimed.");
}

TEST(CoverageReport, IsInEveryFormOfTheReport) {
  const plumb::Run run =
      Given{.run = rows(every(0.15625, 14)), .reference_keys = "coverage = { to = 1.5 }"}.reported();
  const Document document = document_of(evaluate(run, {}), {});
  const Document& coverage = document.at("verdicts")[0].at("coverage");
  EXPECT_EQ(coverage.at("demanded"), 4);
  EXPECT_EQ(coverage.at("compared"), 4);
  EXPECT_EQ(coverage.at("interpolated"), 3);
  EXPECT_EQ(coverage.at("longest_gap"), 0.15625);
  EXPECT_EQ(coverage.at("last"), 1.5);
  EXPECT_EQ(coverage.at("lacking"), "");
  EXPECT_EQ(document.at("errors")[0].at("coverage"), coverage);
  EXPECT_EQ(coverage_json(*verdicts_of(document).at(0).coverage), coverage) << "it is read back as it was";
  const std::string words =
      "over 4 of 4 times from 0 to 1.5 s, outputs at most 0.156 s apart; 3 of them interpolated";
  for (const std::string& text : {to_junit(document), to_summary(document), to_page(document, {})}) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_NE(text.find("the case claims no more than to 1.5 s"), std::string::npos) << text;
  }
  EXPECT_NE(to_page(document, {}).find("<td class=\"n\">4 of 4</td><td class=\"n\">0 to 1.5</td>"),
            std::string::npos);
}

TEST(CoverageReport, WhatIsNotRunIsSkippedAndIsNoFailureAndNoPass) {
  const plumb::Run run = Given{.run = rows({0, 2})}.reported();
  const Document document = document_of(evaluate(run, {}), {});
  const std::string junit = to_junit(document);
  EXPECT_NE(junit.find("failures=\"0\" skipped=\"1\""), std::string::npos) << junit;
  EXPECT_NE(junit.find("<skipped message=\"only 2 of 5 times of the reference"), std::string::npos) << junit;
  EXPECT_NE(to_summary(document).find("| **not run** | verification |"), std::string::npos)
      << to_summary(document);
  EXPECT_NE(to_page(document, {}).find("class=\"tag not-run\""), std::string::npos);
}

}  // namespace coverage_test
}  // namespace plumb
