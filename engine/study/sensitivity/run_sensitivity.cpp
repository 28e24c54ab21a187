#include "engine/study/sensitivity/run_sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string_view>

#include "engine/base/errors.h"
#include "engine/integrate/integrate.h"
#include "engine/read/case_sections.h"
#include "engine/read/changed_case.h"
#include "engine/read/model_numbers.h"
#include "engine/run/mode_table.h"
#include "engine/study/sensitivity/sensitivity_members.h"

namespace plumb {
namespace {

/// The case as it is, judged.
struct Base {
  Outcome outcome = Outcome::not_run;
  std::string message;
  std::vector<JudgedCriterion> criteria;
};

template <class Archive>
void members(Archive& a, Base& base) {
  a("outcome", base.outcome);
  a("message", base.message);
  a("criteria", base.criteria);
}

/// Each output that of the one before.
void delay(Trajectory& trajectory) {
  for (std::vector<Eigen::VectorXd>* states : {&trajectory.q, &trajectory.v}) {
    if (states->empty()) continue;
    states->insert(states->begin(), states->front());
    states->pop_back();
  }
}

Run run_of(LoadedCase loaded, double time_limit, bool late = false) {
  Run run;
  run.loaded = std::move(loaded);
  run.trajectory = integrate(run.loaded.spec, {}, time_limit);
  if (late) delay(run.trajectory);
  if (run.trajectory.outcome != Outcome::completed) return run;
  run.probes = probe(run.loaded.spec, run.trajectory);
  run.modes = mode_table(run.loaded.spec, run.trajectory);
  return run;
}

class Trials {
 public:
  Trials(const LoadedCase& loaded, double time_limit, const Judge& judge,
         const std::vector<JudgedCriterion>& criteria)
      : loaded_(loaded), time_limit_(time_limit), judge_(judge), criteria_(criteria) {}

  Trial of(const PlannedBlunder& blunder) const {
    return with(blunder.overrides, blunder.kind == Blunder::lumped_mass,
                blunder.kind == Blunder::late_output);
  }

  Trial with(const std::vector<std::string>& overrides, bool lumped = false, bool late = false) const {
    Trial trial;
    LoadedCase changed;
    try {
      changed = load_changed(loaded_.source, overrides);
    } catch (const InputError& error) {
      trial.message = without_prefix(error.what());
    } catch (const UsageError& error) {
      trial.message = without_prefix(error.what());
    }
    if (!trial.message.empty()) return trial;
    changed.spec.cable.lumped = lumped;
    for (Reference& reference : changed.references) reference.cable = {};
    changed.spec.given_runs = loaded_.spec.given_runs;
    changed.given_runs = loaded_.given_runs;
    const Run run = run_of(std::move(changed), time_limit_, late);
    trial.outcome = run.trajectory.outcome;
    trial.message = run.trajectory.message;
    if (trial.outcome != Outcome::completed) return trial;
    const std::vector<JudgedCriterion> judged = judge_(run);
    for (const JudgedCriterion& criterion : criteria_) {
      const auto same = std::find_if(judged.begin(), judged.end(),
                                     [&](const JudgedCriterion& any) { return any.name == criterion.name; });
      trial.found.push_back(same == judged.end() ? Found{-1, true} : Found{same->value, !same->met});
    }
    return trial;
  }

 private:
  /// The values are not what a user typed.
  static std::string without_prefix(std::string text) {
    constexpr std::string_view prefix = "--set ";
    if (text.starts_with(prefix)) text.erase(0, prefix.size());
    return text;
  }

  const LoadedCase& loaded_;
  double time_limit_;
  const Judge& judge_;
  const std::vector<JudgedCriterion>& criteria_;
};

Base judged_as_it_is(const LoadedCase& loaded, const Judge& judge) {
  const Run run = run_of(loaded, no_time_limit);
  Base base{run.trajectory.outcome, run.trajectory.message, {}};
  if (base.outcome == Outcome::completed) base.criteria = judge(run);
  return base;
}

}  // namespace

SensitivitySpec sensitivity_of(const Case& spec) {
  return spec.sensitivity ? *spec.sensitivity : default_sensitivity(spec);
}

Sensitivity run_sensitivity(const LoadedCase& loaded, const Judge& judge, Runner& runner) {
  const auto started = std::chrono::steady_clock::now();
  Sensitivity result;
  const SensitivitySpec spec = sensitivity_of(loaded.spec);
  result.largest = spec.largest;
  result.time_limit = spec.time_limit;
  Base base = std::move(runner
                            .run<Base>({"sensitivity", Division::shared},
                                       {{"as it is", [&] { return judged_as_it_is(loaded, judge); }}})
                            .front());
  result.criteria = std::move(base.criteria);
  std::vector<bool> wanted;
  for (const JudgedCriterion& criterion : result.criteria) wanted.push_back(criterion.met);
  if (base.outcome != Outcome::completed)
    result.left_out = fmt::format("the case itself does not complete: {}", base.message);
  else if (wanted.empty())
    result.left_out = "the case has no criterion";
  else if (std::find(wanted.begin(), wanted.end(), true) == wanted.end())
    result.left_out = "the case meets none of its criteria";
  if (!result.left_out.empty()) return result;

  const Trials trials(loaded, spec.time_limit, judge, result.criteria);
  std::vector<StudyPoint<SearchedSide>> searches;
  for (const ModelNumber& number : model_numbers(loaded.spec)) {
    if (std::find(spec.numbers.begin(), spec.numbers.end(), number.key) == spec.numbers.end()) continue;
    result.numbers.push_back({number.key, number.words, {}, {}});
    for (const bool up : {true, false})
      searches.push_back({fmt::format("{} {}", number.key, up ? "up" : "down"), [&, key = number.key, up] {
                            return smallest_changes(wanted, spec.largest - 1, [&](double change) {
                              const double factor = up ? 1 + change : 1 / (1 + change);
                              // Kept, so that a search that is interrupted goes on.
                              return runner.once<Trial>(
                                  "sensitivity run", {fmt::format("{} × {:.17g}", key, factor), [&] {
                                                        return trials.with(scaled(loaded.spec, key, factor));
                                                      }});
                            });
                          }});
  }
  const auto found_sides = runner.plan("sensitivity to numbers", std::move(searches));
  for (PlannedBlunder& blunder : planned_blunders(loaded.spec, spec.blunders))
    result.blunders.push_back({std::move(blunder), {}});
  std::vector<StudyPoint<Trial>> points;
  for (const BlunderSensitivity& of : result.blunders)
    points.push_back({of.blunder.name, [&] { return of.applies() ? trials.of(of.blunder) : Trial(); }});
  const auto made = runner.plan("sensitivity to blunders", std::move(points));
  runner.compute("sensitivity");
  runner.conclude();
  std::vector<SearchedSide>& sides = *found_sides;
  for (const SearchedSide& side : sides) result.runs += side.runs;
  for (std::size_t k = 0; k < result.numbers.size(); ++k) {
    result.numbers[k].up = std::move(sides[2 * k]);
    result.numbers[k].down = std::move(sides[2 * k + 1]);
  }

  for (std::size_t k = 0; k < made->size(); ++k) {
    BlunderSensitivity& of = result.blunders[k];
    of.trial = std::move((*made)[k]);
    if (of.applies() && of.trial.outcome == Outcome::not_run) of.blunder.why_not = of.trial.message;
    result.runs += of.applies() ? 1 : 0;
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return result;
}

}  // namespace plumb
