#include "report/results.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {

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
  const auto count = std::ssize(results.verdicts);
  std::string text = count == 0     ? "The case names no criterion, so nothing is claimed"
                     : met == count ? fmt::format("All {} criteria are met", count)
                                    : fmt::format("{} of {} criteria are not met", count - met, count);
  const Run& run = results.run;
  std::string distances;
  for (std::size_t r = 0; r < run.loaded.references.size(); ++r) {
    const SeriesError* worst = nullptr;
    for (const SeriesError& error : results.errors)
      if (error.reference == r && !error.times.empty() && (!worst || error.max > worst->max)) worst = &error;
    if (!worst) continue;
    distances += fmt::format(
        "{} {:.2g} {} from the {} figures at {} times", distances.empty() ? "" : " and", worst->max,
        worst->unit, run.loaded.references[r].kind == ReferenceKind::published ? "published" : "computed",
        worst->times.size());
  }
  if (!distances.empty())
    text += fmt::format(": the {}-element run is at most{}", run.loaded.spec.cable.elements, distances);
  return text + ".";
}

}  // namespace plumb
