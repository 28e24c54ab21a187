#include "report/verdict/results.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {

std::string counted(long n, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t k = 0; k < items.size(); ++k)
    text += (k == 0 ? "" : k + 1 == items.size() ? " and " : ", ") + items[k];
  return text;
}

std::string step_cuts(long times, double shortest) {
  if (times <= 0) return "";
  std::string text = "cut " + counted(times, "time", "times");
  if (shortest > 0) text += fmt::format(", to {:.3g} s at the shortest", shortest);
  return text;
}

bool has_energy_to_keep(const Trajectory& trajectory) {
  return trajectory.equilibria.negative_eigenvalues.empty();
}

std::string drift_in_words(const Trajectory& trajectory) {
  if (!has_energy_to_keep(trajectory)) return "none, as the load grew and did work";
  const double relative = trajectory.relative_energy_drift();
  if (relative < 0) return "that cannot be told";
  return fmt::format(
      "{:.3g} of the {} kinetic energy{}", relative,
      trajectory.kinetic_scale() == trajectory.energies.front().kinetic ? "first" : "greatest",
      trajectory.energy_drift() <= trajectory.energy_round_off() ? ", no more than rounding makes" : "");
}

namespace {

/// ", and 2 comparisons with figures of another model are shown"; empty for none.
std::string beside(long others) {
  if (others == 0) return "";
  return fmt::format(", and {} with figures of another model {} shown",
                     counted(others, "comparison", "comparisons"), others == 1 ? "is" : "are");
}

/// Those of the run that is reported.
std::vector<Verdict> own_verdicts(const Results& results) {
  const auto own = std::count_if(results.errors.begin(), results.errors.end(),
                                 [](const SeriesError& error) { return !error.given_run; });
  return {results.verdicts.begin(), results.verdicts.begin() + own};
}

Outcome judged_outcome(const Results& results) {
  if (!results.solved()) return results.run.trajectory.outcome;
  const std::vector<Verdict> own = own_verdicts(results);
  if (count_of(own, VerdictStatus::failed) > 0) return Outcome::inaccurate;
  return all_passed(results.verdicts) && all_met(own) ? Outcome::accurate : Outcome::completed;
}

/// "known: tip.y is not met", "known: tip.y and 2 other criteria are not run"; empty for none of that status.
std::string those_in_words(const std::vector<Verdict>& verdicts, VerdictStatus status) {
  const auto first = std::find_if(verdicts.begin(), verdicts.end(),
                                  [&](const Verdict& verdict) { return verdict.status == status; });
  if (first == verdicts.end()) return "";
  const char* what = status == VerdictStatus::failed ? "met" : "run";
  const long more = count_of(verdicts, status) - 1;
  return more == 0 ? fmt::format("{} is not {}", first->name, what)
                   : fmt::format("{} and {} are not {}", first->name,
                                 counted(more, "other criterion", "other criteria"), what);
}

/// "the run with 4 elements", "the external run chrono".
std::string run_in_words(const Case& spec) {
  return reports_given_run(spec) ? "the external run " + spec.given_runs.front().name
                                 : "the run with " + counted(spec.cable.elements, "element", "elements");
}

/// What became of the external runs beside the one that is reported, a sentence each.
std::string given_in_words(const Results& results) {
  const Case& spec = results.run.loaded.spec;
  std::string text;
  for (std::size_t k = reports_given_run(spec) ? 1 : 0; k < spec.given_runs.size(); ++k) {
    const std::string& name = spec.given_runs[k].name;
    long all = 0, met = 0;
    for (const Verdict& verdict : results.verdicts) {
      if (!verdict.name.starts_with(name + ": ")) continue;
      all += verdict.status == VerdictStatus::another_model ? 0 : 1;
      met += verdict.status == VerdictStatus::passed ? 1 : 0;
    }
    const GivenDistance* worst = nullptr;
    for (const GivenDistance& distance : results.distances)
      if (distance.given_run == k && distance.unit == "m" && !distance.times.empty() &&
          (!worst || !(distance.max <= worst->max)))
        worst = &distance;
    text += fmt::format(
        " {}: {}", name,
        all == 0 ? "no criterion" : fmt::format("{} of {} met", met, counted(all, "criterion", "criteria")));
    if (worst)
      text += fmt::format(", at most {:.3g} m from {} ({})", worst->max, reported_name(spec), worst->column);
    text += ".";
  }
  return text;
}

/// The outcome as the first sentence of a headline.
std::string outcome_in_words(const Results& results) {
  if (results.outcome == Outcome::accurate) return "Accurate.";
  if (results.outcome == Outcome::inaccurate) return fmt::format("Inaccurate: {}.", outcome_reason(results));
  return fmt::format("Completed, but {}.", outcome_reason(results));
}

}  // namespace

Results evaluate(const Run& run, const Stages& stages, const std::vector<RunSection>& sections) {
  Results results{run, series_errors(run), {}, stages};
  results.verdicts = verdicts(run, results.errors);
  results.distances = given_distances(run);
  for (Verdict& verdict : distance_verdicts(run, results.distances))
    results.verdicts.push_back(std::move(verdict));
  results.sections = sections;
  for (const RunSection& section : sections)
    if (section.judge) section.judge(results.verdicts, results.errors);
  results.outcome = judged_outcome(results);
  return results;
}

std::string met_in_words(const std::vector<Verdict>& verdicts) {
  const long others = count_of(verdicts, VerdictStatus::another_model);
  std::string missed;
  if (count_of(verdicts, VerdictStatus::failed) == 1)
    for (const Verdict& verdict : verdicts)
      if (verdict.status == VerdictStatus::failed)
        missed = fmt::format("; not met is {}: {}", verdict.name, verdict.message);
  return fmt::format("{} of {} met{}{}.", count_of(verdicts, VerdictStatus::passed),
                     counted(std::ssize(verdicts) - others, "criterion", "criteria"), beside(others), missed);
}

std::string outcome_reason(const Results& results) {
  const std::vector<Verdict> all = own_verdicts(results);
  switch (results.outcome) {
    case Outcome::accurate:
      return "every criterion is met";
    case Outcome::inaccurate:
      return those_in_words(all, VerdictStatus::failed);
    case Outcome::completed: {
      const long not_run = count_of(all, VerdictStatus::not_run),
                 others = count_of(all, VerdictStatus::another_model);
      if (not_run + others == std::ssize(all))
        return others == 0 ? "not held against anything" : "held against figures of another model only";
      if (not_run > 0) return "not held against every reference";
      const std::string failed = those_in_words(results.verdicts, VerdictStatus::failed);
      return failed.empty() ? those_in_words(results.verdicts, VerdictStatus::not_run) : failed;
    }
    default:
      return results.run.trajectory.message;
  }
}

std::string headline(const Results& results) {
  const Trajectory& trajectory = results.run.trajectory;
  if (!results.solved())
    return fmt::format("The integration did not finish ({}): {}.", word(trajectory.outcome),
                       trajectory.message);
  const std::vector<Verdict> own = own_verdicts(results);
  const long others = count_of(results.verdicts, VerdictStatus::another_model),
             all = std::ssize(results.verdicts) - others,
             failed = count_of(results.verdicts, VerdictStatus::failed),
             not_run = count_of(results.verdicts, VerdictStatus::not_run);
  std::string text = outcome_in_words(results) + " ";
  if (all == 0)
    text += "The case names no criterion, so nothing is claimed";
  else if (failed + not_run == 0)
    text += all == 1 ? "The one criterion is met" : fmt::format("All {} criteria are met", all);
  else if (not_run == 0)
    text += fmt::format("{} of {} not met", failed, counted(all, "criterion", "criteria"));
  else
    text += fmt::format("Of {}, {} not met and {} not run", counted(all, "criterion", "criteria"), failed,
                        not_run);
  text += beside(others);

  const Run& run = results.run;
  std::string distances;
  for (std::size_t r = 0; r < run.loaded.references.size(); ++r) {
    const SeriesError* worst = nullptr;
    for (std::size_t k = 0; k < own.size(); ++k) {
      const SeriesError& error = results.errors[k];
      if (error.reference != r || results.verdicts[k].status == VerdictStatus::not_run) continue;
      if (!worst || !(error.max <= worst->max)) worst = &error;
    }
    if (!worst) continue;
    distances += fmt::format("{} {:.3g} {} from the {} figures (at {} of {} {}s)",
                             distances.empty() ? "" : " and", worst->max, worst->unit,
                             worst->exact                                                ? "exact"
                             : run.loaded.references[r].kind == ReferenceKind::published ? "published"
                                                                                         : "computed",
                             worst->times.size(), run.loaded.references[r].times.size(),
                             worst->coverage.of_modes ? "mode" : "time");
  }
  if (!distances.empty()) text += fmt::format(": {} is at most{}", run_in_words(run.loaded.spec), distances);
  text += "." + given_in_words(results);
  for (const RunSection& section : results.sections) text += section.sentence;
  return text;
}

}  // namespace plumb
