#pragma once

#include "engine/study/uncertainty/error_budget.h"
#include "report/figure/figures.h"

namespace plumb {

inline constexpr const char* budget_figure_name = "error_budget";

/// A bar chart of an error budget: a group for each series, in it a bar for each thing that is changed alone,
/// and one for all of them together. Distances are those at every interval where there are such, else those
/// at the times of the reference. What did not complete has no bar.
Figure budget_figure(const ErrorBudget& budget);

}  // namespace plumb
