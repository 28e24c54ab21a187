#pragma once

#include <string>
#include <vector>

#include "engine/study/work_precision/work_precision_file.h"
#include "report/study/study_report.h"

namespace plumb {

/// An observed order may differ by this much from the stated one.
inline constexpr double order_tolerance = 0.3;

/// Verdicts, all of verification: a reference certified, on the case's own mesh and for the converged
/// solution, and for each curve of fixed steps on that mesh with one stated order and an asymptotic part,
/// that order seen.
std::vector<Verdict> study_verdicts(const WorkPrecision& study);

/// "springs: 24 links, 2.3 s on laptop, 1 thread: 0.011 m from the mesh of the case, 0.02 m from the
/// converged motion": each point of other programs.
std::vector<std::string> given_points_in_words(const WorkPrecision& study);

/// What its report says: how many runs there are, the verdicts, and the cheapest ways to each error.
StudyReport evaluate_study(const Study& study, const Stages& stages);

/// "3 out-of-time, 2 unstable": the runs that did not complete, by reason, and those that are stable but
/// wrong; empty where there are none.
std::string failures_in_words(const WorkPrecision& study);

}  // namespace plumb
