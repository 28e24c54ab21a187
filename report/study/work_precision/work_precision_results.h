#pragma once

#include <string>
#include <vector>

#include "engine/study/work_precision/work_precision_file.h"
#include "report/base/stages.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// Everything the report of a study says, apart from how it looks.
struct StudyResults {
  const Study& study;
  std::vector<Verdict> verdicts;
  Stages stages;  ///< those before the report itself

  bool any_completed() const;
};

/// An observed order may differ by this much from the stated one.
inline constexpr double order_tolerance = 0.3;

/// Verdicts, all of verification: a reference certified, on the case's own mesh and for the converged
/// solution, and for each curve of fixed steps on that mesh with one stated order and an asymptotic part,
/// that order seen.
std::vector<Verdict> study_verdicts(const WorkPrecision& study);

StudyResults evaluate_study(const Study& study, const Stages& stages);

/// The study in one sentence: how many runs, and the cheapest way to the smallest error.
std::string headline(const StudyResults& results);

/// "3 out-of-time, 2 unstable": the runs that did not complete, by reason, and those that are stable but
/// wrong; empty where there are none.
std::string failures_in_words(const WorkPrecision& study);

/// results.json, junit.xml and summary.md of a study.
std::string to_json(const StudyResults& results);
std::string to_junit(const StudyResults& results);
std::string to_summary(const StudyResults& results);

}  // namespace plumb
