#pragma once

#include <limits>

#include "engine/study/economy/run_economy.h"
#include "engine/study/sensitivity/sensitivity.h"
#include "engine/study/sweep/sweep.h"
#include "engine/study/variants/run_variants.h"
#include "tests/engine/study/sweep/tiny_sweep.h"
#include "tests/report/made_run.h"

/// Studies made by hand, of numbers that no integration gave.
namespace plumb {

/// Two runs of one method, one of which is infinitely far off.
inline Sweep made_sweep() {
  Sweep sweep;
  sweep.loaded = tiny_sweep_case();
  sweep.spec = {2, 1, 0.01, 0.2};
  for (long number = 0; number < 2; ++number) {
    SweepRun run;
    run.number = number;
    run.overrides = {"method.name=rk4"};
    run.method = "rk4";
    run.outcome = number == 0 ? Outcome::accurate : Outcome::unstable;
    run.error = number == 0 ? 1e-3 : std::numeric_limits<double>::infinity();
    sweep.runs.push_back(run);
  }
  sweep.provenance = {{"program", "test"}};
  return sweep;
}

/// One variant, which fails as expected, but earlier.
inline VariantsStudy made_variants() {
  VariantResult variant;
  variant.spec.name = "slow";
  variant.spec.overrides = {"method.step=0.2"};
  variant.spec.outcome = "unstable";
  variant.run = run_with("made").loaded.spec;
  variant.trajectory.outcome = Outcome::unstable;
  variant.trajectory.message = "it grew";
  variant.trajectory.end_time = 0.5;
  variant.trajectory.times = {0, 0.5};
  variant.trajectory.energies = {{2, 0, 0, 0}, {3, 0, 0, 0}};
  variant.probes.times = variant.trajectory.times;
  variant.probes.columns = {{"tip.x", "m", {1, 2}}};
  variant.expectations = {{{"end-time", "", 1.2, 0.05, "a closed form"}, "s", 0.5}};
  variant.spec.expectations = {variant.expectations[0].expected};
  const CaseSource plain = run_with("made").loaded.source;
  const LoadedCase loaded = load_case({{"case.toml", plain.file.text + R"([[study.variant]]
name = "slow"
set = { method.step = 0.2 }
outcome = "unstable"
[[study.variant.expect]]
quantity = "end-time"
value = 1.2
within = 0.05
source = "a closed form"
)"},
                                       {},
                                       plain.references});
  return {loaded, {"Made", {variant}, {{"program", "test"}}}};
}

/// One picture with one candidate, and one random scene.
inline EconomyStudy made_economy_study() {
  EconomyStudy study;
  study.loaded = tiny_sweep_case();
  study.spec = economy_study_of(study.loaded.spec);
  study.reference = "one";
  SceneNeed need;
  need.name = "320 by 180";
  TriedCandidate candidate;
  candidate.candidate.cable = study.loaded.spec.cable;
  candidate.candidate.method = study.loaded.spec.method;
  candidate.outcome = Outcome::completed;
  candidate.estimate = 0.25;
  candidate.why = "the cheapest";
  need.economy.tried = {candidate};
  need.economy.chosen = 0;
  study.needs = {need};
  study.scenes = {{1, {"scene.size=[320,180]"}, "rk4", 0.5, true, 0.1, 0.05, 0.01, 0.001, 0.1, ""}};
  study.provenance = {{"program", "test"}};
  return study;
}

/// Four criteria of made_run.h's case: the first notices numbers and blunders, the second a run that fails
/// and a finer mesh alone, the third is not met, and the fourth notices no more than a factor of 4.
inline SensitivityStudy made_sensitivity() {
  SensitivityStudy study;
  study.loaded = run_with("made").loaded;
  Sensitivity& found = study.result;
  found.largest = 100;
  found.time_limit = 10;
  found.criteria = {{"known: tip.y", "m", 0.035, 0.01, true},
                    {"known: tip.x", "m", 0.5, 0.01, true},
                    {"known: tip.z", "m", 0.02, 0.03, false},
                    {"known: <mid.y>", "m", 0.2, 0.03, true}};
  const NoticedChange none;
  found.numbers = {{"cable.density",
                    "density",
                    {12, 99, "", {{0.0625, false}, {0.5, true}, none, {3, false}}},
                    {14, 99, "", {{0.25, false}, none, none, none}}},
                   {"cable.bending_stiffness",
                    "bending stiffness",
                    {10, 9, "the run would take more than 10 s", {none, none, none, none}},
                    {10, 99, "", {{0.5, false}, none, none, none}}},
                   {"loads.gravity.1",
                    "gravity along y",
                    {10, 99, "", {none, none, none, none}},
                    {10, 99, "", {none, none, none, none}}}};
  const auto completed = [](bool first, bool second) {
    return Trial{Outcome::completed, "", {{0.1, first}, {0.1, second}, {-1, false}, {0.1, false}}};
  };
  found.blunders = {
      {{Blunder::chain, "a chain of springs", {"cable.model=chain"}, ""}, completed(true, false)},
      {{Blunder::double_mesh, "twice the mesh", {"cable.elements=2"}, ""}, completed(false, true)},
      {{Blunder::half_mesh, "half the mesh", {}, "the mesh has one element"}, {}},
      {{Blunder::density_unit, "a density of a thousandth", {"cable.density=1"}, ""},
       {Outcome::unstable, "it grew", {}}}};
  found.runs = 60;
  found.seconds = 0.5;
  study.provenance = {{"program", "test"}};
  return study;
}

}  // namespace plumb
