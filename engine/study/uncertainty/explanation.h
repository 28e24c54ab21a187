#pragma once

#include <string>
#include <vector>

#include "engine/study/uncertainty/error_budget.h"
#include "engine/study/uncertainty/uncertainty.h"

namespace plumb {

/// A run of a budget minus its base at the times of a comparison, in its unit; not a number where the budget
/// has no such time.
std::vector<double> difference_at(const ErrorBudget& budget, const BudgetRun& run,
                                  const SeriesUncertainty& series);

/// Which items of a budget account for E at the times where it is beyond k u, in words: of those in which the
/// run differs from the published computation the one whose difference from the base leaves the least of E
/// there, by the root of the mean of squares, and further ones added to it until no more than half is left.
/// That there are none is said. Empty where nothing is beyond k u. `error`, `validation` and `beyond` of the
/// series are to be known.
std::string explanation(const ErrorBudget& budget, const SeriesUncertainty& series);

}  // namespace plumb
