#pragma once

#include "report/document.h"

namespace plumb {

/// A probe may move by this share of its largest value before it counts as a regression: room for another
/// compiler's rounding, not for another answer.
inline constexpr double default_regression_share = 1e-9;

/// Adds to a report what became of it since an earlier one: verdicts of regression, which say that nothing
/// moved and never that anything is right, and under `baseline` where the earlier report is, when it was
/// made, and what changed. The outcome is left as it is; all_criteria_met and the headline take the verdicts
/// in. `share` is what each column may move by, of its largest value.
void hold_against_baseline(Document& document, const Document& baseline, const std::string& path,
                           double share);

}  // namespace plumb
