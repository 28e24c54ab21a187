#include <gtest/gtest.h>

#include <algorithm>

#include "engine/read/given_probes.h"
#include "engine/run/run_file.h"
#include "report/document/document.h"
#include "report/page/page.h"
#include "report/verdict/results.h"
#include "tests/engine/given_case.h"
#include "tests/report/made_run.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace given_report_test {

/// Eleven times that are none of the reference's but the first, of y = −t², which a cubic is exact for.
std::string parabola(double first, double last, double error = 0) {
  std::string text = "t,tip.y\n";
  for (int k = 0; k <= 10; ++k) {
    const double t = first + (last - first) * k / 10;
    text += std::to_string(t) + "," + std::to_string(-t * t + error) + "\n";
  }
  return text;
}

plumb::Run given(const std::string& file, const std::string& keys = "", const std::string& extra = "") {
  return reported_run(load_case(given_case(file, keys, extra)), {});
}

TEST(GivenReport, ATrajectoryOnItsOwnTimesIsHeldAgainstAReferenceAndSaysHowItIsInterpolated) {
  const plumb::Run run = given(parabola(0, 1.1, 0.01));
  const Results results = evaluate(run, {});
  ASSERT_EQ(results.verdicts.size(), 1U);
  const Verdict& verdict = results.verdicts[0];
  EXPECT_EQ(verdict.status, VerdictStatus::passed) << verdict.message;
  EXPECT_EQ(verdict.kind, VerdictKind::validation);
  EXPECT_NEAR(verdict.value, 0.01, 2e-6) << "numbers in the file have six decimals";
  EXPECT_EQ(results.errors[0].coverage.interpolated, 2U);
  EXPECT_NE(verdict.message.find(
                "over 3 of 3 times from 0 to 1 s, outputs at most 0.11 s apart; 2 of them interpolated"),
            std::string::npos)
      << verdict.message;
  EXPECT_NE(verdict.criterion.find("|chrono − published|"), std::string::npos) << verdict.criterion;
  EXPECT_EQ(results.outcome, Outcome::accurate);
  EXPECT_NE(headline(results).find("the external run chrono is at most"), std::string::npos)
      << headline(results);
}

TEST(GivenReport, ItFailsWhereItIsTooFar) {
  const plumb::Run run = given(parabola(0, 1, 0.2));
  EXPECT_EQ(evaluate(run, {}).verdicts[0].status, VerdictStatus::failed);
}

TEST(GivenReport, NothingIsExtrapolatedSoThatTimesOutsideAreNotRun) {
  for (const auto& [first, last, has] :
       {std::tuple{0.1, 1.1, 2}, std::tuple{0.0, 0.9, 2}, std::tuple{0.6, 0.7, 0}}) {
    const plumb::Run run = given(parabola(first, last), "", "[time]\nend = 1\n");
    const Results results = evaluate(run, {});
    EXPECT_EQ(results.verdicts[0].status, VerdictStatus::not_run) << first << " " << last;
    EXPECT_EQ(results.errors[0].times.size(), static_cast<std::size_t>(has)) << first << " " << last;
    EXPECT_EQ(results.errors[0].coverage.demanded, 3U);
    EXPECT_NE(results.verdicts[0].message.find("nothing is extrapolated"), std::string::npos)
        << results.verdicts[0].message;
    EXPECT_NE(results.outcome, Outcome::accurate);
  }
}

TEST(GivenReport, ReferenceTimesAreMatchedToTheTimesAfterAFirstThatIsMissed) {
  const plumb::Run run = given("t,tip.y\n0.5,-0.25\n1,-1\n");
  const SeriesError error = series_errors(run).at(0);
  EXPECT_EQ(error.times, (std::vector<double>{0.5, 1}));
  EXPECT_EQ(error.expected, (std::vector<double>{-0.25, -1}));
  EXPECT_EQ(error.max, 0);
  EXPECT_EQ(error.coverage.interpolated, 0U);
}

TEST(GivenReport, AColumnThatItDoesNotHaveIsNotRun) {
  const plumb::Run run = given("t,tip.x\n0,1\n1,2\n", "columns = { \"tip.y\" = \"\" }");
  const Verdict verdict = evaluate(run, {}).verdicts.at(0);
  EXPECT_EQ(verdict.status, VerdictStatus::not_run);
  EXPECT_EQ(verdict.message,
            "only 0 of 3 times of the reference can be compared: chrono has no column tip.y");
}

TEST(GivenReport, TwoGivenRunsAreHeldAgainstEachOtherAtTheTimesOfBoth) {
  const plumb::Run run = [] {
    CaseSource source =
        given_case(parabola(0, 1), "[[run]]\nfile = \"coarse.csv\"\ntolerances = { \"tip.y\" = 0.125 }");
    source.given_runs.push_back({"coarse.csv", "t,tip.y\n0,0\n0.25,0.4375\n0.5,0.25\n"});
    return reported_run(load_case(source), {});
  }();
  const Results results = evaluate(run, {});
  ASSERT_EQ(results.distances.size(), 1U);
  const GivenDistance& distance = results.distances[0];
  EXPECT_EQ(distance.coverage.demanded, 12U) << "eleven, and 0.25 s";
  ASSERT_EQ(distance.times, (std::vector<double>{0, 0.25, 0.5})) << "three rows are too few to interpolate";
  EXPECT_NEAR(distance.difference[1], 0.5, 1e-6) << "given minus reported: 0.4375 − (−0.0625)";
  EXPECT_NEAR(distance.max, 0.5, 2e-6);
  ASSERT_EQ(results.verdicts.size(), 3U);
  EXPECT_EQ(results.verdicts[0].name, "known: tip.y");
  EXPECT_EQ(results.verdicts[0].status, VerdictStatus::passed) << results.verdicts[0].message;
  EXPECT_EQ(results.verdicts[1].name, "coarse: known: tip.y");
  EXPECT_EQ(results.verdicts[1].status, VerdictStatus::not_run) << results.verdicts[1].message;
  EXPECT_EQ(results.verdicts[2].name, "coarse: chrono: tip.y");
  EXPECT_EQ(results.verdicts[2].kind, VerdictKind::verification);
  EXPECT_EQ(results.verdicts[2].status, VerdictStatus::not_run) << "it ends before the other does";
  EXPECT_EQ(results.outcome, Outcome::completed) << "not every verdict of every run passed";
}

TEST(GivenReport, ADistanceIsJudgedWhereTheCaseGivesATolerance) {
  for (const auto& [tolerance, status] :
       {std::pair{"0.02", VerdictStatus::passed}, std::pair{"0.005", VerdictStatus::failed}}) {
    CaseSource source = given_case(
        parabola(0, 1),
        "[[run]]\nfile = \"other.csv\"\ntolerances = { \"tip.y\" = " + std::string(tolerance) + " }");
    source.given_runs.push_back({"other.csv", parabola(0, 1, 0.01)});
    const plumb::Run run = reported_run(load_case(source), {});
    EXPECT_EQ(evaluate(run, {}).verdicts.at(2).status, status) << tolerance;
  }
}

/// Rows of the columns at the times of the reference, y = −t² + error and the others 0.
std::string table(const std::vector<std::string>& columns, double error = 0) {
  std::string text = "t";
  for (const std::string& column : columns) text += "," + column;
  for (const double t : {0.0, 0.5, 1.0}) {
    text += "\n" + std::to_string(t);
    for (const std::string& column : columns)
      text += "," + std::to_string(column == "tip.y" ? -t * t + error : 0);
  }
  return text + "\n";
}

TEST(GivenReport, AColumnThatIsNotComparedHidesNoneBehindIt) {
  const std::string other = "[[run]]\nfile = \"other.csv\"\ntolerances = { \"tip.y\" = 0.005 }";
  for (const std::vector<std::string>& columns :
       {std::vector<std::string>{"tip.y"}, {"tip.x", "tip.y"}, {"tip.y", "tip.z"}}) {
    CaseSource source = given_case(table(columns), other);
    source.given_runs.push_back({"other.csv", table({"tip.x", "tip.y", "tip.z"}, 0.01)});
    const plumb::Run run = reported_run(load_case(source), {});
    const Results results = evaluate(run, {});
    EXPECT_EQ(results.distances.size(), columns.size()) << columns.front();
    ASSERT_EQ(results.verdicts.size(), 3U) << columns.front();
    EXPECT_EQ(results.verdicts[2].name, "other: chrono: tip.y");
    EXPECT_EQ(results.verdicts[2].status, VerdictStatus::failed) << results.verdicts[2].message;
  }
}

TEST(GivenReport, AGivenRunBesideOneOfPlumbsOwnIsHeldAgainstTheReferenceToo) {
  plumb::Run run = run_with("a");
  CaseSource source = run.loaded.source;
  source.file.text += "\n[[run]]\nfile = \"other.csv\"\n";
  source.given_runs = {{"other.csv", table({"tip.y"}, 5)}};
  run.loaded = load_case(source);
  const std::vector<Verdict> found = evaluate(run, {}).verdicts;
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].name, "other: known: tip.y");
  EXPECT_EQ(found[1].status, VerdictStatus::failed) << found[1].message;
}

TEST(GivenReport, WhatIsNotKnownOfItIsNoNumberInTheDocumentAndSaidSoOnThePage) {
  const plumb::Run run = given(parabola(0, 1), "program = \"Chrono <8>\"");
  Pictures pictures;
  pictures.animation_notes = {"chrono gives one place"};
  const Document document = document_of(evaluate(run, {}), pictures);
  EXPECT_TRUE(document.at("energy").is_null());
  EXPECT_EQ(document.at("computed_by"), "Chrono <8> (chrono.csv)");
  EXPECT_EQ(document.at("solve").at("method"), "given");
  EXPECT_EQ(document.at("solve").at("steps"), -1);
  EXPECT_EQ(document.at("solve").at("energy_drift"), -1);
  EXPECT_FALSE(document.at("case").contains("method"));
  const std::string page = to_page(document, pictures);
  for (const char* words : {"Not known: the run was computed by Chrono &lt;8&gt; (chrono.csv)",
                            "Not known: computed by Chrono &lt;8&gt; (chrono.csv)", "There is no animation",
                            "chrono gives one place", "nothing is extrapolated"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  EXPECT_EQ(page.find("Chrono <8>"), std::string::npos);
  EXPECT_EQ(page.find("first kinetic energy"), std::string::npos);
  EXPECT_NE(to_summary(document).find("energy and cost are not known"), std::string::npos)
      << to_summary(document);
  EXPECT_NE(to_junit(document).find("given by Chrono &lt;8&gt;"), std::string::npos) << to_junit(document);
}

TEST(GivenReport, TimesThatTheCaseStatesAreOnThePageAndInTheDocument) {
  const std::string point = "[[run.point]]\nfile = \"chrono.csv\"\nseconds = 7\nlabel = \"step 1 ms\"";
  const auto told = [&](const std::string& keys) {
    const Document document = document_of(evaluate(given(parabola(0, 1), keys), {}), {});
    const std::string page = to_page(document, {});
    const std::size_t at = page.find("Time that the case states");
    return at == page.npos ? std::string() : page.substr(at, page.find("</p>", at) - at);
  };
  EXPECT_EQ(told(""), "");
  EXPECT_EQ(told("seconds = 2.5\nthreads = 4\nmachine = \"laptop\"\nyardstick = 0.5\n" + point),
            "Time that the case states, on 4 threads of laptop: 2.5 s, 7 s (step 1 ms). The yardstick (plumb "
            "yardstick) takes 0.5 s there.");
  EXPECT_EQ(told(point), "Time that the case states, on 1 thread of this machine: 7 s (step 1 ms).");
  const Document timed = document_of(evaluate(given(parabola(0, 1), "seconds = 2.5\n" + point), {}), {});
  EXPECT_NE(to_summary(timed).find("; its energy is not known"), std::string::npos) << to_summary(timed);
  const Document& given_run = timed.at("given_runs")[0];
  EXPECT_EQ(given_run.at("seconds"), 2.5);
  EXPECT_EQ(given_run.at("points")[0].at("seconds"), 7);
  EXPECT_EQ(given_run.at("yardstick"), -1);
}

TEST(GivenReport, ARunFileHoldsTheGivenFileSoThatItCanBeReportedWithoutIt) {
  const TemporaryFolder folder;
  const plumb::Run run = given(parabola(0, 1));
  write_text(folder / "run.h5", encode_run(run));
  const plumb::Run back = read_run((folder / "run.h5").string());
  EXPECT_EQ(to_csv(back.probes), to_csv(run.probes));
  EXPECT_EQ(back.loaded.source.given_runs.at(0).text, run.loaded.source.given_runs.at(0).text);
  EXPECT_EQ(back.trajectory.times, run.trajectory.times);
  EXPECT_TRUE(back.trajectory.energies.empty());
  EXPECT_EQ(back.loaded.spec, run.loaded.spec);
}

}  // namespace given_report_test
}  // namespace plumb
