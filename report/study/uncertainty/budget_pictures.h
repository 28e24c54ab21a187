#pragma once

#include <vector>

#include "engine/study/uncertainty/error_budget.h"
#include "report/figure/pictures.h"

namespace plumb {

/// Draws the figure of an error budget into a folder: figures/error_budget.png. Throws OutputError when
/// drawing or writing fails, Interrupted when the user stops it.
std::vector<Picture> draw_budget(const ErrorBudget& budget, OutputFolder& folder);

}  // namespace plumb
