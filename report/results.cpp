#include "report/results.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {

std::string counted(long n, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string drift_in_words(const Trajectory& trajectory) {
  const double relative = trajectory.relative_energy_drift();
  if (relative < 0) return "that cannot be told";
  return fmt::format(
      "{:.3g} of the {} kinetic energy", relative,
      trajectory.kinetic_scale() == trajectory.energies.front().kinetic ? "first" : "greatest");
}

Results evaluate(const Run& run, const Stages& stages) {
  Results results{run, series_errors(run), {}, stages};
  results.verdicts = verdicts(run, results.errors);
  return results;
}

std::string headline(const Results& results) {
  const Trajectory& trajectory = results.run.trajectory;
  if (!results.solved())
    return fmt::format("The integration did not finish ({}): {}.", word(trajectory.outcome),
                       trajectory.message);
  const auto met = std::count_if(results.verdicts.begin(), results.verdicts.end(),
                                 [](const Verdict& v) { return v.status == VerdictStatus::passed; });
  const auto count = std::ssize(results.verdicts), missed = count - met;
  std::string text = count == 0 ? "The case names no criterion, so nothing is claimed"
                     : missed == 0
                         ? fmt::format("{} met", count == 1 ? "The one criterion is"
                                                            : fmt::format("All {} criteria are", count))
                         : fmt::format("{} of {} {} not met", missed, counted(count, "criterion", "criteria"),
                                       missed == 1 ? "is" : "are");
  const Run& run = results.run;
  std::string distances;
  for (std::size_t r = 0; r < run.loaded.references.size(); ++r) {
    const SeriesError* worst = nullptr;
    for (const SeriesError& error : results.errors)
      if (error.reference == r && !error.times.empty() && (!worst || error.max > worst->max)) worst = &error;
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
