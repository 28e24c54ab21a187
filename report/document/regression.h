#pragma once

#include <string>
#include <vector>

#include "engine/case/probe_table.h"
#include "report/document/changes.h"

namespace plumb {

/// A probe may move by this share of its largest value before it counts as a regression: room for another
/// compiler's rounding, not for another answer.
inline constexpr double default_regression_share = 1e-9;

/// Throws InputError where the baseline at `path` is of another case than `now` (the `case` of a report),
/// with the keys that differ and both values, shortened where they are many.
void refuse_other_case(const Document& baseline, const std::string& path, const Document& now);

/// What two reports were made with that may round otherwise: "compiler, processor"; empty: the same.
std::string rounds_otherwise(const Document& baseline, const Document& now);

/// Adds to a report what became of it since an earlier one of the same case: verdicts of regression, which
/// say that nothing moved and never that anything is right, and under `baseline` where the earlier report is,
/// when it was made, and what changed. What either lacks has moved; where there is nothing to compare, that
/// is a verdict that was not run; a baseline that was changed after it was written
/// is one that failed, unless it has no check sum. The outcome is left as it is; all_criteria_met and the
/// headline take the verdicts in. `share`, a finite number, is what each column may move by, of its largest
/// value. `reach`, of a baseline that was made with something that rounds otherwise: how far each column may
/// be from itself for that alone (rounding_reach); it may move by as much, and from where that is more than a
/// hundredth of its largest value on it is not comparable, which is said and no regression. What was not
/// compared is listed. Throws InputError for a baseline of another case.
void hold_against_baseline(Document& document, const Document& baseline, const std::string& path,
                           double share, const std::vector<PictureMove>& pictures = {},
                           const ProbeTable& reach = {});

}  // namespace plumb
