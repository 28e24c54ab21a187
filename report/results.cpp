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
  const Case& spec = results.run.loaded.spec;
  for (std::size_t r = 0; r < spec.references.size(); ++r) {
    const SeriesError* worst = nullptr;
    for (const SeriesError& error : results.errors)
      if (error.reference == r && !error.times.empty() && (!worst || error.max > worst->max)) worst = &error;
    if (!worst) continue;
    text += fmt::format(
        "; the {}-element run is within {:.2g} {} of the {} figures", spec.cable.elements, worst->max,
        worst->unit,
        results.run.loaded.references[r].kind == ReferenceKind::published ? "published" : "computed");
  }
  return text + ".";
}

}  // namespace plumb
