#pragma once

#include <string>
#include <vector>

#include "engine/run/run.h"
#include "report/base/stages.h"
#include "report/verdict/given_distance.h"
#include "report/verdict/run_section.h"
#include "report/verdict/series_error.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// Version of results.json; rises when a key changes its meaning or goes away. One that is added is
/// missing in earlier documents: it is to be read with a default.
inline constexpr int results_version = 2;

/// Everything a report says, apart from how it looks.
struct Results {
  const Run& run;
  std::vector<SeriesError> errors;
  /// One for each of `errors`, then those of `distances`, then those of `sections`.
  std::vector<Verdict> verdicts;
  Stages stages;  ///< those before the report itself
  /// `accurate` where the run completed, was held against a reference, and every verdict of it and of the
  /// external runs beside it passed; `inaccurate` where it completed and one of its own failed; else how the
  /// integration itself ended.
  Outcome outcome = Outcome::not_run;
  std::vector<GivenDistance> distances = {};  ///< of external runs to the one that is reported
  std::vector<RunSection> sections = {};      ///< what else was computed of it, in the order of results.json

  bool solved() const { return run.trajectory.outcome == Outcome::completed; }
};

/// Compares a run with its references; `sections` add to the verdicts what they have to say.
Results evaluate(const Run& run, const Stages& stages, const std::vector<RunSection>& sections = {});

/// "1 step", "2 steps".
std::string counted(long n, const std::string& one, const std::string& many);

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& items);

/// "3 of 4 criteria met."
std::string met_in_words(const std::vector<Verdict>& verdicts);

/// "cut 12 times, to 3e-05 s at the shortest", where steps were tried and repeated shorter so many times;
/// empty for none. A shortest step of -1 is not known.
std::string step_cuts(long times, double shortest);

/// Why the outcome is what it is: "every criterion is met", "known: tip.y is not met", "not held against
/// anything", or what ended the integration.
std::string outcome_reason(const Results& results);

/// False of equilibria under a load that grows: it does work, and there is no energy to keep.
bool has_energy_to_keep(const Trajectory& trajectory);

/// The energy drift relative to what it is held against: "3.4e-14 of the first kinetic energy".
std::string drift_in_words(const Trajectory& trajectory);

/// The report in one sentence: how many criteria are met and the greatest distance to each reference.
std::string headline(const Results& results);

/// The longest summary.md, bytes, below the 64 KiB that a page of a CI takes.
inline constexpr std::size_t longest_summary = 63 * 1024;

/// The verdicts as a table in Markdown, failures first, of at most some `room` bytes: where that is too
/// little the last are left out, and counted.
std::string verdict_table(const std::vector<Verdict>& verdicts, std::size_t room);

}  // namespace plumb
