#include "report/results.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {

std::string counted(long n, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string step_cuts(const Trajectory& trajectory) {
  const long times = trajectory.counters.rejected_steps;
  if (times <= 0) return "";
  std::string text = "cut " + counted(times, "time", "times");
  if (trajectory.shortest_cut > 0)
    text += fmt::format(", to {:.3g} s at the shortest", trajectory.shortest_cut);
  return text;
}

std::string drift_in_words(const Trajectory& trajectory) {
  const double relative = trajectory.relative_energy_drift();
  if (relative < 0) return "that cannot be told";
  return fmt::format(
      "{:.3g} of the {} kinetic energy", relative,
      trajectory.kinetic_scale() == trajectory.energies.front().kinetic ? "first" : "greatest");
}

Results evaluate(const Run& run, const Stages& stages, const Study* study) {
  Results results{run, series_errors(run), {}, stages, study};
  results.verdicts = verdicts(run, results.errors);
  return results;
}

std::string headline(const Results& results) {
  const Trajectory& trajectory = results.run.trajectory;
  if (!results.solved())
    return fmt::format("The integration did not finish ({}): {}.", word(trajectory.outcome),
                       trajectory.message);
  const auto count_of = [&](VerdictStatus status) {
    return std::count_if(results.verdicts.begin(), results.verdicts.end(),
                         [&](const Verdict& v) { return v.status == status; });
  };
  const auto all = std::ssize(results.verdicts), failed = count_of(VerdictStatus::failed),
             not_run = count_of(VerdictStatus::not_run);
  std::string text;
  if (all == 0)
    text = "The case names no criterion, so nothing is claimed";
  else if (failed + not_run == 0)
    text = all == 1 ? "The one criterion is met" : fmt::format("All {} criteria are met", all);
  else if (not_run == 0)
    text = fmt::format("{} of {} not met", failed, counted(all, "criterion", "criteria"));
  else
    text = fmt::format("Of {}, {} not met and {} not evaluated", counted(all, "criterion", "criteria"),
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
