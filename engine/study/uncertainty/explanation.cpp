#include "engine/study/uncertainty/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

/// What some items leave of E where it is beyond k u.
struct Rest {
  double share = 1;        // of E, roots of the means of squares
  std::size_t within = 0;  // times with |rest| ≤ k u
};

Rest rest_of(const std::vector<double>& accounted, const SeriesUncertainty& series) {
  Rest rest;
  double left = 0, all = 0;
  for (const std::size_t t : series.beyond) {
    const double remains = series.error[t] - accounted[t];
    left += remains * remains;
    all += series.error[t] * series.error[t];
    rest.within += std::abs(remains) <= coverage_factor * series.validation[t];
  }
  rest.share =
      std::isfinite(left) && all > 0 ? std::sqrt(left / all) : std::numeric_limits<double>::infinity();
  return rest;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}

}  // namespace

std::vector<double> difference_at(const ErrorBudget& budget, const BudgetRun& run,
                                  const SeriesUncertainty& series) {
  std::vector<double> difference(series.times.size(), std::numeric_limits<double>::quiet_NaN());
  const auto distance = std::find_if(run.distances.begin(), run.distances.end(),
                                     [&](const SeriesDistance& any) { return any.series == series.series; });
  if (distance == run.distances.end() || distance->difference.size() != budget.times.size())
    return difference;
  constexpr double rounding = 1e-9;
  std::size_t k = 0;
  for (std::size_t t = 0; t < series.times.size(); ++t) {
    const double slack = rounding * (1 + series.times[t]);
    while (k < budget.times.size() && budget.times[k] < series.times[t] - slack) ++k;
    if (k < budget.times.size() && budget.times[k] <= series.times[t] + slack)
      difference[t] = distance->difference[k];
  }
  return difference;
}

std::string explanation(const ErrorBudget& budget, const SeriesUncertainty& series) {
  constexpr double enough = 0.5;
  if (series.beyond.empty()) return "";
  std::vector<const BudgetEntry*> open;
  for (const BudgetEntry& entry : budget.entries)
    if (entry.of_run && entry.run.completed()) open.push_back(&entry);
  std::vector<double> accounted(series.times.size(), 0.0);
  Rest rest;
  std::string names;
  while (rest.share > enough && !open.empty()) {
    const auto with = [&](const BudgetEntry* entry) {
      return sum(accounted, difference_at(budget, entry->run, series));
    };
    const auto best =
        std::min_element(open.begin(), open.end(), [&](const BudgetEntry* a, const BudgetEntry* b) {
          return rest_of(with(a), series).share < rest_of(with(b), series).share;
        });
    const Rest next = rest_of(with(*best), series);
    if (!(next.share < rest.share)) break;
    rest = next;
    accounted = with(*best);
    names += (names.empty() ? "the " : " and the ") + (*best)->name;
    open.erase(best);
  }
  if (rest.share > enough) return "nothing in the error budget accounts for half of it";
  return fmt::format(
      "accounted for by {} of the error budget, but for {:.0f} %: without that the run is within {:g} u at "
      "{} of these {} times",
      names, 100 * rest.share, coverage_factor, rest.within, series.beyond.size());
}

}  // namespace plumb
