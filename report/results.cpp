#include "report/results.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/economy_text.h"

namespace plumb {

std::string counted(long n, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string step_cuts(long times, double shortest) {
  if (times <= 0) return "";
  std::string text = "cut " + counted(times, "time", "times");
  if (shortest > 0) text += fmt::format(", to {:.3g} s at the shortest", shortest);
  return text;
}

std::string drift_in_words(const Trajectory& trajectory) {
  const double relative = trajectory.relative_energy_drift();
  if (relative < 0) return "that cannot be told";
  return fmt::format(
      "{:.3g} of the {} kinetic energy", relative,
      trajectory.kinetic_scale() == trajectory.energies.front().kinetic ? "first" : "greatest");
}

namespace {

long count_of(const std::vector<Verdict>& verdicts, VerdictStatus status) {
  return std::count_if(verdicts.begin(), verdicts.end(),
                       [&](const Verdict& verdict) { return verdict.status == status; });
}

Outcome judged_outcome(const Run& run, const std::vector<Verdict>& verdicts) {
  if (run.trajectory.outcome != Outcome::completed) return run.trajectory.outcome;
  if (count_of(verdicts, VerdictStatus::failed) > 0) return Outcome::inaccurate;
  return !verdicts.empty() && all_passed(verdicts) ? Outcome::accurate : Outcome::completed;
}

/// The outcome as the first sentence of a headline.
std::string outcome_in_words(const Results& results) {
  if (results.outcome == Outcome::accurate) return "Accurate.";
  if (results.outcome == Outcome::inaccurate) return fmt::format("Inaccurate: {}.", outcome_reason(results));
  return fmt::format("Completed, but {}.", outcome_reason(results));
}

}  // namespace

Results evaluate(const Run& run, const Stages& stages, const Study* study, const Economy* economy) {
  Results results{run, series_errors(run), {}, stages, study, economy};
  results.verdicts = verdicts(run, results.errors);
  if (economy) results.verdicts.push_back(economy_verdict(*economy));
  results.outcome = judged_outcome(run, results.verdicts);
  return results;
}

std::string outcome_reason(const Results& results) {
  const std::vector<Verdict>& all = results.verdicts;
  switch (results.outcome) {
    case Outcome::accurate:
      return "every criterion is met";
    case Outcome::inaccurate: {
      const auto first = std::find_if(all.begin(), all.end(), [](const Verdict& verdict) {
        return verdict.status == VerdictStatus::failed;
      });
      const long more = count_of(all, VerdictStatus::failed) - 1;
      return more == 0 ? first->name + " is not met"
                       : fmt::format("{} and {} are not met", first->name,
                                     counted(more, "other criterion", "other criteria"));
    }
    case Outcome::completed:
      return count_of(all, VerdictStatus::passed) == 0 ? "not held against anything"
                                                       : "not held against every reference";
    default:
      return results.run.trajectory.message;
  }
}

std::string headline(const Results& results) {
  const Trajectory& trajectory = results.run.trajectory;
  if (!results.solved())
    return fmt::format("The integration did not finish ({}): {}.", word(trajectory.outcome),
                       trajectory.message);
  const auto all = std::ssize(results.verdicts), failed = count_of(results.verdicts, VerdictStatus::failed),
             not_run = count_of(results.verdicts, VerdictStatus::not_run);
  std::string text = outcome_in_words(results) + " ";
  if (all == 0)
    text += "The case names no criterion, so nothing is claimed";
  else if (failed + not_run == 0)
    text += all == 1 ? "The one criterion is met" : fmt::format("All {} criteria are met", all);
  else if (not_run == 0)
    text += fmt::format("{} of {} not met", failed, counted(all, "criterion", "criteria"));
  else
    text += fmt::format("Of {}, {} not met and {} not evaluated", counted(all, "criterion", "criteria"),
                        failed, not_run);

  const Run& run = results.run;
  std::string distances;
  for (std::size_t r = 0; r < run.loaded.references.size(); ++r) {
    const SeriesError* worst = nullptr;
    for (std::size_t k = 0; k < results.errors.size(); ++k) {
      const SeriesError& error = results.errors[k];
      if (error.reference != r || results.verdicts[k].status == VerdictStatus::not_run) continue;
      if (!worst || !(error.max <= worst->max)) worst = &error;
    }
    if (!worst) continue;
    distances += fmt::format(
        "{} {:.3g} {} from the {} figures (at {} of {} times)", distances.empty() ? "" : " and", worst->max,
        worst->unit, run.loaded.references[r].kind == ReferenceKind::published ? "published" : "computed",
        worst->times.size(), run.loaded.references[r].times.size());
  }
  if (!distances.empty())
    text += fmt::format(": the run with {} is at most{}",
                        counted(run.loaded.spec.cable.elements, "element", "elements"), distances);
  return text + ".";
}

}  // namespace plumb
