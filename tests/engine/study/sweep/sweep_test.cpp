#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/base/errors.h"
#include "engine/integrate/integrate.h"
#include "engine/study/sweep/run_sweep.h"
#include "engine/study/sweep/sweep_json.h"
#include "tests/engine/small_case.h"
#include "tests/engine/study/changed_json.h"
#include "tests/engine/study/in_memory.h"
#include "tests/engine/study/sweep/tiny_sweep.h"

namespace plumb {
namespace sweep_test {

long wrongly_accurate(const Sweep& sweep) {
  return std::count_if(sweep.runs.begin(), sweep.runs.end(),
                       [&](const SweepRun& run) { return run.wrongly_accurate(sweep.spec.tolerance); });
}

TEST(Sweep, EveryCaseIsJudgedFiniteAndWithoutFault) {
  const Sweep sweep = run_sweep(tiny_sweep_case(), InMemory());
  ASSERT_EQ(sweep.runs.size(), 60U);
  std::set<Outcome> seen;
  for (std::size_t k = 0; k < sweep.runs.size(); ++k) {
    const SweepRun& run = sweep.runs[k];
    EXPECT_EQ(run.number, static_cast<long>(k));
    EXPECT_EQ(run.fault, "") << "case " << k;
    EXPECT_TRUE(run.judged()) << "case " << k << " ended " << word(run.outcome);
    EXPECT_TRUE(run.finite) << "case " << k;
    EXPECT_EQ(run.message.empty(), run.outcome == Outcome::accurate || run.outcome == Outcome::inaccurate)
        << run.message;
    EXPECT_LE(run.disagreement, 0.1 * sweep.spec.tolerance) << "case " << k;
    seen.insert(run.outcome);
  }
  EXPECT_EQ(wrongly_accurate(sweep), 0);
  EXPECT_TRUE(seen.contains(Outcome::accurate) && seen.contains(Outcome::inaccurate) &&
              seen.contains(Outcome::unstable))
      << "a sweep that does not reach beyond the limits shows nothing";
}

TEST(Sweep, AJudgeThatCallsEveryRunAccurateIsFoundOut) {
  const auto blind = [](const Trajectory& run, const Trajectory& reference, double, double horizon) {
    return classify_outcome(run, reference, std::numeric_limits<double>::max(), horizon);
  };
  const LoadedCase loaded = tiny_sweep_case({"study.sweep.cases=40"});
  const Sweep honest = run_sweep(loaded, InMemory());
  const Sweep sweep = run_sweep(loaded, InMemory(), blind);
  long found_out = 0;
  for (std::size_t k = 0; k < honest.runs.size(); ++k) {
    // On a busy machine one of the two may be out of time.
    if (honest.runs[k].outcome != Outcome::inaccurate || sweep.runs[k].outcome != Outcome::accurate) continue;
    EXPECT_TRUE(sweep.runs[k].wrongly_accurate(sweep.spec.tolerance))
        << "case " << k << " is " << sweep.runs[k].second_error << " m off";
    ++found_out;
  }
  EXPECT_GT(found_out, 3);
}

TEST(Sweep, AJudgeThatLooksAtTheWrongRunIsFoundOut) {
  // As one would that compared the reference with itself.
  const auto mistaken = [](const Trajectory& run, const Trajectory& reference, double tolerance,
                           double horizon) {
    Judgement judgement = classify_outcome(run, reference, tolerance, horizon);
    if (run.outcome == Outcome::completed)
      judgement = classify_outcome(reference, reference, tolerance, horizon);
    return judgement;
  };
  EXPECT_GT(wrongly_accurate(run_sweep(tiny_sweep_case(), InMemory(), mistaken)), 0);
}

TEST(Sweep, ARunIsRepeatedAloneByItsNumberOrItsOverrides) {
  const LoadedCase loaded = tiny_sweep_case({"study.sweep.cases=50"});
  const Sweep sweep = run_sweep(loaded, InMemory());
  long compared = 0;
  for (const SweepRun& run : sweep.runs) {
    if (run.outcome == Outcome::out_of_time || run.number % 7 != 0) continue;
    const SweepRun again = run_of_sweep(loaded, sweep.spec, run.number);
    if (again.outcome == Outcome::out_of_time) continue;
    EXPECT_EQ(again.overrides, run.overrides);
    EXPECT_EQ(again.outcome, run.outcome) << "case " << run.number;
    EXPECT_EQ(again.message, run.message);
    EXPECT_EQ(again.error, run.error);
    EXPECT_EQ(again.second_error, run.second_error);
    CaseSource source = loaded.source;
    source.overrides = run.overrides;
    const Trajectory alone = integrate(load_case(source).spec, {}, sweep.spec.time_limit);
    EXPECT_EQ(alone.message, run.message);
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

TEST(Sweep, ARunThatIsDisplacedBeyondToleranceIsWronglyAccurate) {
  SweepRun run;
  run.outcome = Outcome::accurate;
  run.error = 0;
  run.disagreement = 1e-6;
  run.second_error = 1e-3;
  EXPECT_FALSE(run.wrongly_accurate(1e-3));
  run.second_error = 1.002e-3;
  EXPECT_TRUE(run.wrongly_accurate(1e-3));
  run.outcome = Outcome::inaccurate;
  EXPECT_FALSE(run.wrongly_accurate(1e-3));
  run.outcome = Outcome::accurate;
  for (const double second : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    run.second_error = second;
    EXPECT_TRUE(run.wrongly_accurate(1e-3)) << second;
  }
  run.second_error = 1e-4;
  run.disagreement = std::nan("");
  EXPECT_TRUE(run.wrongly_accurate(1e-3)) << "references that are not known to agree vouch for nothing";
}

TEST(Sweep, StudiesOfTheFileDoNotHinderItsCases) {
  // Its steps are beyond some of the ends that are drawn, which matters to that study alone.
  const Sweep sweep =
      run_sweep(tiny_sweep_case({"time.end=10", "time.output_interval=1", "study.work_precision.end=5",
                                 "study.work_precision.largest_step=4", "study.sweep.cases=30"}),
                InMemory());
  for (const SweepRun& run : sweep.runs) EXPECT_EQ(run.fault, "") << run.number;
}

Sweep made_sweep() {
  Sweep sweep;
  sweep.loaded = tiny_sweep_case({"study.sweep.cases=2"});
  sweep.spec = sweep_of(sweep.loaded.spec);
  sweep.runs = {{0, {"a=1"}, "rk4", Outcome::accurate, "", 1e-4, 1.1e-4, 1e-7, 0.05, 0.25, true, ""},
                {1,
                 {"a=1", "b=\"x\""},
                 "rk4",
                 Outcome::not_run,
                 "",
                 std::numeric_limits<double>::infinity(),
                 -1,
                 -1,
                 -1,
                 -1,
                 false,
                 "crashed (signal 11)"}};
  sweep.provenance = {{"program", "Plumb"}, {"machine", "any"}};
  return sweep;
}

TEST(SweepJson, HoldsAllOfASweep) {
  const Sweep sweep = made_sweep();
  const std::string text = encode_sweep(sweep);
  const Sweep again = decode_sweep(text, "study.json");
  EXPECT_EQ(encode_sweep(again), text);
  EXPECT_EQ(again.spec, sweep.spec);
  EXPECT_EQ(again.loaded.spec, sweep.loaded.spec);
  EXPECT_EQ(again.runs[1].overrides, sweep.runs[1].overrides);
  EXPECT_EQ(again.runs[1].fault, "crashed (signal 11)");
  EXPECT_TRUE(std::isinf(again.runs[1].error));
  EXPECT_EQ(again.runs[0].second_error, 1.1e-4);
  EXPECT_EQ(again.provenance, sweep.provenance);
}

TEST(SweepJson, WhatIsNotFiniteIsToldFromWhatIsNotThere) {
  Sweep sweep = made_sweep();
  sweep.runs[0].error = NAN;
  sweep.runs[1].error = -INFINITY;
  const Sweep again = decode_sweep(encode_sweep(sweep), "study.json");
  EXPECT_TRUE(std::isnan(again.runs[0].error));
  EXPECT_EQ(again.runs[1].error, -INFINITY);
  EXPECT_TRUE(sweep_run_json(sweep.runs[0]).at("error").is_null()) << "as results.json has it";
}

TEST(SweepJson, AnyValueThatWasChangedIsReadOrRefusedInWords) {
  using Json = nlohmann::ordered_json;
  expect_changes_read_or_refused(Json::parse(encode_sweep(made_sweep())), 200,
                                 [](const Json& changed) -> std::string {
                                   try {
                                     decode_sweep(changed.dump(), "study.json");
                                   } catch (const InputError& error) {
                                     return error.what();
                                   }
                                   return "";
                                 });
}

TEST(SweepJson, AnythingElseIsRefused) {
  const std::string text = encode_sweep(made_sweep());
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"kind\":\"sweep\"", "\"kind\":\"sweeps\""},
           {"\"version\":2", "\"version\":3"},
           {"\"version\":2", "\"version\":1"},
           {"\"cases\":2", "\"cases\":3"},
           {"\"tolerance\":0.001", "\"tolerance\":-1"},
           {"\"number\":1", "\"number\":5"},
           {"\"outcome\":\"accurate\"", "\"outcome\":\"fine\""},
           {"\"fault\"", "\"falt\""},
           {"\"finite\":false", "\"finite\":7"},
       }) {
    try {
      decode_sweep(with(text, from, to), "study.json");
      ADD_FAILURE() << "accepted with " << to;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("study.json: cannot be used: "), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace sweep_test
}  // namespace plumb
