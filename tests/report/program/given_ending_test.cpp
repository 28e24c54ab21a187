#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/errors.h"
#include "engine/read/given_probes.h"
#include "engine/run/run_file.h"
#include "report/document/document.h"
#include "report/program/run_pipeline.h"
#include "report/verdict/results.h"
#include "tests/engine/given_case.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace given_ending_test {

/// The bytes of a run file of Plumb's that ended so.
std::string run_file(Outcome outcome, const std::string& message = "the energy grew") {
  plumb::Run run = run_with("a");
  run.trajectory.outcome = outcome;
  run.trajectory.message = message;
  return encode_run(run);
}

plumb::Run reported(const std::string& file) {
  return reported_run(load_case(given_case(file)), {});
}

/// With `other` as a second run that is held against the first.
Results beside(plumb::Run& run, const std::string& first, const std::string& other,
               const std::string& tolerance = "0.125") {
  CaseSource source =
      given_case(first, "[[run]]\nfile = \"other\"\ntolerances = { \"tip.y\" = " + tolerance + " }\n");
  source.given_runs.push_back({"other", other});
  run = reported_run(load_case(source), {});
  return evaluate(run, {});
}

/// y = −t² every 0.1 s to 1 s, off by `error` in between.
std::string parabola(double error = 0, double last = 1) {
  std::string text = "t,tip.y\n";
  for (int k = 0; k / 10.0 <= last; ++k) {
    const double t = k / 10.0;
    text += std::to_string(t) + "," + std::to_string(-t * t + (k % 10 > 0 ? error : 0)) + "\n";
  }
  return text;
}

std::string said(const Verdict& verdict) {
  return std::string(word(verdict.status)) + ": " + verdict.message;
}

TEST(GivenEnding, ARunFileThatCompletedIsHeldAgainstTheReference) {
  const plumb::Run run = reported(run_file(Outcome::completed, ""));
  EXPECT_EQ(evaluate(run, {}).verdicts.at(0).status, VerdictStatus::passed)
      << said(evaluate(run, {}).verdicts.at(0));
}

TEST(GivenEnding, ARunFileThatFailedPassesNothingWhateverItsNumbers) {
  for (const Outcome outcome : {Outcome::unstable, Outcome::diverged, Outcome::no_convergence,
                                Outcome::singular, Outcome::unstable_equilibrium, Outcome::out_of_time}) {
    const plumb::Run run = reported(run_file(outcome));
    const Results results = evaluate(run, {});
    EXPECT_EQ(results.verdicts.at(0).status, VerdictStatus::not_run) << word(outcome);
    EXPECT_NE(results.verdicts.at(0).message.find(word(outcome)), std::string::npos)
        << results.verdicts.at(0).message;
    EXPECT_EQ(results.outcome, outcome);
    const Document document = document_of(results, {});
    EXPECT_EQ(document.at("all_criteria_met"), false);
    EXPECT_EQ(status_of(document), ExitStatus::criterion_not_met) << "it was not solved here";
    EXPECT_NE(document.at("given_runs")[0].at("notes").dump().find("the run in it failed"), std::string::npos)
        << document.at("given_runs")[0].at("notes");
  }
}

TEST(GivenEnding, AFailureBesideTheRunThatIsReportedPassesNothingEither) {
  plumb::Run run;
  const Results results = beside(run, parabola(), run_file(Outcome::unstable));
  ASSERT_EQ(results.verdicts.size(), 3U);
  EXPECT_EQ(results.verdicts[0].status, VerdictStatus::passed) << said(results.verdicts[0]);
  for (const std::size_t k : {1U, 2U}) {
    EXPECT_EQ(results.verdicts[k].status, VerdictStatus::not_run) << said(results.verdicts[k]);
    EXPECT_EQ(results.verdicts[k].message, "the run of other failed, unstable: the energy grew");
  }
  EXPECT_NE(results.outcome, Outcome::accurate);
}

TEST(GivenEnding, AFailureIsNotLostInARunFileThatIsMadeOfOne) {
  const plumb::Run first = reported(run_file(Outcome::diverged));
  const plumb::Run second = reported(encode_run(first));
  EXPECT_EQ(evaluate(second, {}).verdicts.at(0).status, VerdictStatus::not_run);
  const plumb::Run third = reported(encode_run(second));
  EXPECT_EQ(evaluate(third, {}).outcome, Outcome::diverged);
}

TEST(GivenEnding, ARunFileThatWasCutOrChangedIsRefused) {
  const std::string whole = run_file(Outcome::completed, "");
  const auto refusal = [](const std::string& file) -> std::string {
    try {
      load_case(given_case(file));
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal(whole), "");
  std::string changed = whole;
  const std::size_t word = changed.find("completed");
  ASSERT_NE(word, std::string::npos);
  changed[word] = 'C';
  EXPECT_NE(refusal(changed).find("changed after it was written"), std::string::npos) << refusal(changed);
  const std::string cut = whole.substr(0, whole.rfind("plumb-crc32"));
  EXPECT_NE(refusal(cut).find("cut short"), std::string::npos) << refusal(cut);
}

TEST(GivenEnding, ARunThatEndsBeforeTheCaseOrBeginsLateIsRemarkedOn) {
  CaseSource source = given_case(parabola(0, 0.7), "", "[time]\nend = 1\n");
  const auto remarks = [&] {
    std::string all;
    for (const std::string& remark : load_case(source).remarks) all += remark + "\n";
    return all;
  };
  EXPECT_NE(remarks().find("chrono.csv: the run in it ends at 0.7 s, before the end of the case, 1 s"),
            std::string::npos)
      << remarks();
  source.given_runs[0].text = "t,tip.y\n0.5,-0.25\n1,-1\n";
  EXPECT_NE(remarks().find("chrono.csv: the run in it begins at 0.5 s, not at 0"), std::string::npos)
      << remarks();
  source.given_runs[0].text = parabola();
  EXPECT_EQ(remarks().find("the run in it"), std::string::npos) << remarks();
}

TEST(GivenEnding, ARunFileOfAnotherCaseIsRemarkedOn) {
  const auto remarked = [](CaseSource source) {
    source.given_runs[0].text = run_file(Outcome::completed, "");
    std::string all;
    for (const std::string& remark : load_case(source).remarks) all += remark + "\n";
    return all;
  };
  CaseSource source = given_case("");
  EXPECT_EQ(remarked(source).find("another case"), std::string::npos) << remarked(source);
  source.overrides = {"cable.density=2000", "loads.gravity=[0,-1,0]"};
  EXPECT_NE(
      remarked(source).find("the run in it is of another case: ρA is 0.002 kg/m, that in the file 0.001 "
                            "kg/m; its loads differ"),
      std::string::npos)
      << remarked(source);
}

TEST(RepeatedRun, DoesNotConfirmItself) {
  const std::string in_millimetres = [] {
    std::string text = "t,tip.y [mm]\n";
    for (int k = 0; k <= 10; ++k)
      text += std::to_string(k / 10.0) + "," + std::to_string(-10.0 * k * k) + "\n";
    return text;
  }();
  for (const std::string& other : {parabola(), parabola() + "\n", in_millimetres}) {
    plumb::Run run;
    const Results results = beside(run, parabola(), other);
    ASSERT_EQ(results.verdicts.size(), 3U);
    EXPECT_EQ(results.verdicts[2].status, VerdictStatus::not_run) << said(results.verdicts[2]);
    EXPECT_NE(results.verdicts[2].message.find("one run does not confirm itself"), std::string::npos)
        << results.verdicts[2].message;
    EXPECT_TRUE(std::any_of(run.loaded.remarks.begin(), run.loaded.remarks.end(), [](const std::string& one) {
      return one == "other: the run in it has the same numbers as chrono, which it does not confirm";
    }));
  }
  plumb::Run run;
  EXPECT_EQ(beside(run, parabola(), parabola(1e-3)).verdicts.at(2).status, VerdictStatus::passed);
}

/// y = −t² to 1 s at every `step`-th of 101 times, off by `error`.
std::string thinned(int step, double error = 0) {
  std::string text = "t,tip.y\n";
  for (int k = 0; k <= 100; k += step)
    text += std::to_string(k / 100.0) + "," + std::to_string(-k * k / 1e4 + error) + "\n";
  return text;
}

TEST(RepeatedRun, IsNotConfirmedBySomeOfItsTimesThoughInterpolationBearsTheRest) {
  const auto judged = [](const std::string& first, const std::string& other) {
    plumb::Run run;
    return beside(run, first, other).verdicts.at(2);
  };
  for (const bool first_is_thinned : {false, true}) {
    const auto pair = [&](double error) {
      return first_is_thinned ? judged(thinned(10, error), thinned(1))
                              : judged(thinned(1), thinned(10, error));
    };
    const Verdict copy = pair(0), near = pair(1e-6);
    for (const Verdict& verdict : {copy, near}) {
      ASSERT_TRUE(verdict.coverage);
      EXPECT_EQ(verdict.coverage->lacking, "");
      EXPECT_EQ(verdict.coverage->compared, 101U);
      EXPECT_EQ(verdict.coverage->interpolated, 90U) << "every tenth is an output of both";
    }
    EXPECT_EQ(copy.status, VerdictStatus::not_run) << said(copy);
    EXPECT_NE(copy.message.find("one run does not confirm itself"), std::string::npos) << copy.message;
    EXPECT_EQ(near.status, VerdictStatus::passed) << said(near);
    EXPECT_NE(near.message.find("90 of them interpolated, which may be"), std::string::npos) << near.message;
  }
}

TEST(RepeatedRun, IsNoneWhereOnlyWhatStandsStillIsTheSame) {
  const ProbeTable planar{{0, 1}, {{"tip.y", "m", {0, -1}}, {"tip.z", "m", {0, 0}}}};
  ProbeTable other = planar;
  EXPECT_TRUE(same_run(planar, other));
  other.columns[0].values[1] = -1.001;
  EXPECT_FALSE(same_run(planar, other)) << "another motion";
  other.columns.erase(other.columns.begin());
  EXPECT_FALSE(same_run(planar, other)) << "all planar motions have tip.z = 0";
  other = planar;
  other.times[1] = 1.5;
  EXPECT_FALSE(same_run(planar, other)) << "other times";
  other = {{0, 0.5, 1}, {{"tip.y", "m", {0, -7, -1}}}};
  EXPECT_TRUE(same_run(planar, other)) << "all times of the one and more";
  EXPECT_TRUE(same_run(other, planar));
  other.columns[0].values[2] = -1.001;
  EXPECT_FALSE(same_run(planar, other)) << "another motion at those times";
  other.times = {0, 1, 2};
  other.columns[0].values = {0, -1, -4};
  EXPECT_TRUE(same_run(planar, other)) << "the beginning of it";
  other.columns.clear();
  EXPECT_FALSE(same_run(planar, other)) << "nothing in common";
}

TEST(LooseTolerance, PassesNothingButMissesWhatIsBeyondIt) {
  const auto judged = [](const std::string& file, const std::string& tolerance) {
    CaseSource source = given_case(file);
    source.overrides = {"reference.0.tolerance=" + tolerance};
    const plumb::Run run = reported_run(load_case(source), {});
    return evaluate(run, {}).verdicts.at(0);
  };
  const std::string good = parabola(), still = "t,tip.y\n0,0\n0.5,0\n1,0\n",
                    far = "t,tip.y\n0,0\n0.5,900\n1,0\n";
  EXPECT_EQ(judged(good, "0.99").status, VerdictStatus::passed);
  EXPECT_EQ(judged(good, "1.01").status, VerdictStatus::not_run) << "the reference falls by 1 m";
  EXPECT_EQ(judged(still, "1.01").status, VerdictStatus::not_run);
  EXPECT_EQ(judged(still, "0.99").status, VerdictStatus::failed);
  EXPECT_EQ(judged(good, "1e300").status, VerdictStatus::not_run);
  EXPECT_EQ(judged(far, "100").status, VerdictStatus::failed) << "too far even so";
  EXPECT_EQ(judged(good, "0.99").message.find("stands still"), std::string::npos);
  EXPECT_NE(judged(good, "1").message.find("stands still"), std::string::npos) << judged(good, "1").message;
  EXPECT_NE(judged(still, "5").message.find("a run that does nothing would be within it"), std::string::npos)
      << judged(still, "5").message;
}

TEST(LooseTolerance, OfWhatIsClaimedIsHeldAgainstTheMotionThere) {
  CaseSource source = given_case(parabola());
  source.overrides = {"reference.0.tolerance=0.3", "reference.0.coverage.to=0.5"};
  const plumb::Run run = reported_run(load_case(source), {});
  EXPECT_EQ(evaluate(run, {}).verdicts.at(0).status, VerdictStatus::not_run)
      << "it falls by 0.25 m till then";
}

TEST(LooseTolerance, OfAReferenceThatStandsStillIsHeldAgainstTheLengthOfTheCable) {
  CaseSource source = given_case("t,tip.y\n0,0\n0.5,0\n1,0\n");
  std::string& text = source.references[0].text;
  const std::string rows = "[0.5, -0.25], [1.0, -1.0]";
  text.replace(text.find(rows), rows.size(), "[0.5, 0], [1.0, 0]");
  for (const auto& [tolerance, status] :
       {std::pair{"1e-9", VerdictStatus::passed}, std::pair{"2.1", VerdictStatus::not_run}}) {
    source.overrides = {std::string("reference.0.tolerance=") + tolerance};
    const plumb::Run run = reported_run(load_case(source), {});
    EXPECT_EQ(evaluate(run, {}).verdicts.at(0).status, status) << tolerance;
  }
}

TEST(LooseTolerance, BetweenTwoRunsPassesNothing) {
  for (const auto& [tolerance, status] :
       {std::pair{"0.99", VerdictStatus::passed}, std::pair{"1e6", VerdictStatus::not_run}}) {
    plumb::Run run;
    EXPECT_EQ(beside(run, parabola(), parabola(1e-3), tolerance).verdicts.at(2).status, status) << tolerance;
  }
}

TEST(LooseTolerance, ThatIsNoNumberOrNotPositiveIsRefused) {
  for (const char* tolerance : {"inf", "nan", "-1", "0", "-inf"}) {
    CaseSource source = given_case(parabola());
    source.overrides = {std::string("reference.0.tolerance=") + tolerance};
    EXPECT_THROW(load_case(source), InputError) << tolerance;
    source = given_case(parabola(), "[[run]]\nfile = \"other\"\ntolerances = { \"tip.y\" = " +
                                        std::string(tolerance) + " }\n");
    source.given_runs.push_back({"other", parabola(1e-3)});
    EXPECT_THROW(load_case(source), InputError) << tolerance;
  }
}

}  // namespace given_ending_test
}  // namespace plumb
