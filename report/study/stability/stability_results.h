#pragma once

#include <string>
#include <vector>

#include "engine/study/stability/stability_file.h"
#include "report/study/study_report.h"

namespace plumb {

/// A critical step that was found may differ by this share from the one predicted.
inline constexpr double limit_tolerance = 0.05;

/// The critical step as one number, s: halfway between the one found stable and the one found not to be, by
/// ratio; -1: not found.
double found_step(const CriticalStep& step);
/// The predicted one that it is held against, s: that of the worst state seen, as a run has to pass through
/// it; -1: none.
double predicted_step(const CriticalStep& step);
/// found / predicted − 1; not a number where either is missing.
double deviation(const CriticalStep& step);

/// Verdicts, all of verification: each critical step that is predicted found within limit_tolerance, and
/// each reference known to a tenth of the tolerance.
std::vector<Verdict> stability_verdicts(const Stability& study);

/// What its report says: the runs by outcome, the verdicts, and the steps in words.
StudyReport evaluate_stability(const StabilityStudyFile& study, const Stages& stages);

/// The study on its page. `pictures` are those of stability_figures.
StudySection shown_stability(const Stability& study, const std::vector<Picture>& pictures);

/// "412 accurate, 96 inaccurate, …": the runs of the maps by outcome. A run that serves several maps counts
/// in each.
std::string outcomes_in_words(const Stability& study);

/// "f = 5", or "" where no parameter is varied.
std::string parameter_text(const Stability& study, double value);

/// What maps over an axis have in common, which is not on it: "f = 5, 4 elements".
std::string place_in_words(const Stability& study, MapAxis axis);

/// What a value of a map stands for: "f = 5", "8 elements", "2 s".
std::string value_text(const Stability& study, MapAxis axis, double value);

}  // namespace plumb
