#pragma once

#include <string>
#include <vector>

#include "engine/run/run.h"
#include "engine/study/economy/economy.h"
#include "engine/study/uncertainty/assessment.h"
#include "engine/study/work_precision/work_precision_file.h"
#include "report/base/stages.h"
#include "report/verdict/given_distance.h"
#include "report/verdict/series_error.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// Version of results.json; rises when a key changes its meaning or goes away.
inline constexpr int results_version = 2;

/// Everything a report says, apart from how it looks.
struct Results {
  const Run& run;
  std::vector<SeriesError> errors;
  /// One for each of `errors`, then those of `distances`, then that of the economy.
  std::vector<Verdict> verdicts;
  Stages stages;                 ///< those before the report itself
  const Study* study = nullptr;  ///< the quick work-precision study made with the run, if any
  /// `accurate` where the run completed, was held against a reference, and every verdict of it and of the
  /// given runs beside it passed; `inaccurate` where it completed and one of its own failed; else how the
  /// integration itself ended.
  Outcome outcome = Outcome::not_run;
  const Assessment* assessment = nullptr;  ///< what was computed of its uncertainty, if anything
  const Economy* economy = nullptr;        ///< what the scene needs, where the run was left to it

  std::vector<GivenDistance> distances = {};  ///< of given runs to the one that is reported

  bool solved() const { return run.trajectory.outcome == Outcome::completed; }
};

/// Compares a run with its references. Where there is an assessment, the verdicts say the comparison error
/// and its validation uncertainty; where the run was left to its scene, one says whether that holds.
Results evaluate(const Run& run, const Stages& stages, const Study* study = nullptr,
                 const Assessment* assessment = nullptr, const Economy* economy = nullptr);

/// "1 step", "2 steps".
std::string counted(long n, const std::string& one, const std::string& many);

/// "cut 12 times, to 3e-05 s at the shortest", where steps were tried and repeated shorter so many times;
/// empty for none. A shortest step of -1 is not known.
std::string step_cuts(long times, double shortest);

/// Why the outcome is what it is: "every criterion is met", "known: tip.y is not met", "not held against
/// anything", or what ended the integration.
std::string outcome_reason(const Results& results);

/// The energy drift relative to what it is held against: "3.4e-14 of the first kinetic energy".
std::string drift_in_words(const Trajectory& trajectory);

/// The report in one sentence: how many criteria are met and the greatest distance to each reference.
std::string headline(const Results& results);

/// The verdicts as a table in Markdown, failures first, of bounded length.
std::string verdict_table(const std::vector<Verdict>& verdicts);

}  // namespace plumb
