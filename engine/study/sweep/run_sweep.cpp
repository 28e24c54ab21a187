#include "engine/study/sweep/run_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/base/errors.h"
#include "engine/base/place.h"
#include "engine/integrate/integrate.h"
#include "engine/integrate/method_roles.h"
#include "engine/read/case_sections.h"
#include "engine/read/changed_case.h"
#include "engine/study/reference/node_distance.h"
#include "engine/study/sweep/sweep_cases.h"
#include "engine/study/sweep/sweep_members.h"

namespace plumb {
namespace {

/// References are trusted up to where they part by this share of the tolerance.
constexpr double trusted_share = 0.1;

/// The exact motion of a model by two methods that share no more than the forces.
struct References {
  Trajectory first;          // by the Nyström pair of order 8
  Trajectory second;         // by the Gauss method of order 6
  double horizon = -1;       // s, up to which they agree
  double disagreement = -1;  // m, up to there
};

bool all_finite(const Trajectory& run) {
  const auto finite = [](const Eigen::VectorXd& x) { return x.allFinite(); };
  return std::all_of(run.q.begin(), run.q.end(), finite) && std::all_of(run.v.begin(), run.v.end(), finite) &&
         std::all_of(run.multipliers.begin(), run.multipliers.end(), finite) &&
         std::all_of(run.times.begin(), run.times.end(), [](double t) { return std::isfinite(t); }) &&
         std::all_of(run.energies.begin(), run.energies.end(),
                     [](const Energies& e) {
                       return std::isfinite(e.kinetic) && std::isfinite(e.axial) &&
                              std::isfinite(e.bending) && std::isfinite(e.potential);
                     }) &&
         std::isfinite(run.end_time) && std::isfinite(run.constraint_drift);
}

Trajectory run_with(Case spec, const MethodSpec& method, double time_limit) {
  spec.method = method;
  return integrate(spec, {}, time_limit);
}

/// Both references from loose to tight, until they agree far better than they need to, or as well as they do
/// in time.
References make_references(const Case& model, double tolerance) {
  constexpr double well_agreed = 0.01, time_limit = 5;
  References best;
  MethodSpec pair = plain_method(accurate_explicit(model));
  MethodSpec implicit = plain_method(accurate_implicit());
  for (const auto& [rtol, parts] : {std::pair{1e-9, 10}, std::pair{1e-11, 40}, std::pair{1e-13, 160}}) {
    pair.rtol = pair.atol = rtol;
    implicit.step = model.time.output_interval / parts;
    References found{run_with(model, pair, time_limit), run_with(model, implicit, time_limit)};
    found.horizon = together_until(found.first, found.second, trusted_share * tolerance);
    found.disagreement = node_distance(found.first, found.second, found.horizon);
    const bool whole = found.horizon >= model.time.end && found.disagreement <= well_agreed * tolerance;
    const bool better = found.horizon > best.horizon ||
                        (found.horizon == best.horizon && found.disagreement < best.disagreement);
    if (better || best.first.times.empty()) best = std::move(found);
    if (whole) break;
  }
  return best;
}

/// What cases of one model have in common.
class Model {
 public:
  Model(const LoadedCase& loaded, const SweepSpec& spec, long index, const OutcomeClassifier& judged_by)
      : file_(loaded),
        sweep_(spec),
        judged_by_(judged_by),
        overrides_(model_overrides(loaded.spec, spec.seed, index)),
        model_(load_without_studies(loaded.source.with(overrides_)).spec),
        references_(make_references(model_, spec.tolerance)) {}

  SweepRun run(long number) const {
    SweepRun result;
    result.number = number;
    result.overrides = overrides_;
    try {
      for (std::string& text : method_overrides(file_.spec, model_, sweep_.seed, number))
        result.overrides.push_back(std::move(text));
      const Case spec = load_without_studies(file_.source.with(result.overrides)).spec;
      result.method = spec.method.name;
      judge_run(integrate(spec, {}, {sweep_.time_limit, {spec.time.end}}), result);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      result.fault = fmt::format("threw: {}", reason(error));
    }
    return result;
  }

 private:
  void judge_run(const Trajectory& trajectory, SweepRun& result) const {
    const Judgement judged = judged_by_(trajectory, references_.first, sweep_.tolerance, references_.horizon);
    result.outcome = judged.outcome;
    result.message = trajectory.message;
    result.error = judged.error;
    result.judged_until = judged.judged_until;
    result.seconds = trajectory.solve_seconds;
    result.finite = all_finite(trajectory);
    result.disagreement = references_.disagreement;
    // Whatever the judge made of it.
    if (trajectory.outcome == Outcome::completed)
      result.second_error = node_distance(trajectory, references_.second, references_.horizon);
  }

  const LoadedCase& file_;
  const SweepSpec& sweep_;
  const OutcomeClassifier& judged_by_;
  std::vector<std::string> overrides_;
  Case model_;
  References references_;
};

/// A run of which nothing has come back but how its process ended.
SweepRun lost_run(const LoadedCase& loaded, const SweepSpec& spec, long number, const std::string& fault) {
  SweepRun run;
  run.number = number;
  run.fault = fault;
  run.overrides = model_overrides(loaded.spec, spec.seed, number / runs_of_a_model);
  const Case model = load_without_studies(loaded.source.with(run.overrides)).spec;
  for (std::string& text : method_overrides(loaded.spec, model, spec.seed, number))
    run.overrides.push_back(std::move(text));
  run.method = load_without_studies(loaded.source.with(run.overrides)).spec.method.name;
  return run;
}

}  // namespace

SweepSpec sweep_of(const Case& spec) {
  return spec.sweep ? *spec.sweep : default_sweep(spec.cable);
}

SweepRun run_of_sweep(const LoadedCase& loaded, const SweepSpec& spec, long number) {
  return Model(loaded, spec, number / runs_of_a_model, classify_outcome).run(number);
}

Sweep run_sweep(const LoadedCase& loaded, Runner& runner, const OutcomeClassifier& judged_by) {
  constexpr double patience = 20, least_silence = 60;
  constexpr long models_checked = 250;
  Sweep sweep;
  sweep.loaded = loaded;
  sweep.spec = sweep_of(loaded.spec);
  const SweepSpec& spec = sweep.spec;
  const long models = (spec.cases + runs_of_a_model - 1) / runs_of_a_model;
  // A case that cannot be varied is told at once.
  for (long model = 0; model < std::min(models, models_checked); ++model)
    load_without_studies(loaded.source.with(model_overrides(loaded.spec, spec.seed, model)));

  // Made by the first of its runs that is computed, in the process that computes them.
  std::vector<std::unique_ptr<Model>> made(static_cast<std::size_t>(models));
  std::vector<StudyPoint<SweepRun>> points;
  for (long number = 0; number < spec.cases; ++number) {
    const auto model = static_cast<std::size_t>(number / runs_of_a_model);
    points.push_back({fmt::format("{}", number),
                      [&, number, model] {
                        if (!made[model])
                          made[model] =
                              std::make_unique<Model>(loaded, spec, static_cast<long>(model), judged_by);
                        return made[model]->run(number);
                      },
                      1, model, std::max(least_silence, patience * spec.time_limit)});
  }
  sweep.runs =
      runner.run<SweepRun>({"sweep", Company::apart}, points, [&](std::size_t k, const std::string& fault) {
        return lost_run(loaded, spec, static_cast<long>(k), fault);
      });
  runner.conclude();
  sweep.provenance = runner.provenance();
  return sweep;
}

}  // namespace plumb
