#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/study/sweep/sweep.h"
#include "report/study/study_report.h"

namespace plumb {

/// Verdicts, all of verification: no run ends accurate beyond its tolerance; none crashes, hangs or throws;
/// none holds a number that is not finite; each ends in one of the outcomes of a judged run.
std::vector<Verdict> sweep_verdicts(const Sweep& sweep);

/// What its report says: how many cases there are, and what none of them does, or some do.
StudyReport evaluate_sweep(const Sweep& sweep, const Stages& stages);

/// The shares of the outcomes, for all runs and for each method, as bars.
std::vector<Figure> sweep_figures(const Sweep& sweep);

/// The sweep on its page, with these pictures.
StudySection shown_sweep(const Sweep& sweep, const std::vector<Picture>& pictures);

/// How many runs ended in each outcome.
using OutcomeCounts = std::map<Outcome, long>;
OutcomeCounts outcome_counts(const Sweep& sweep);
/// The same for each method, in the order of method_infos().
std::vector<std::pair<std::string, OutcomeCounts>> outcome_counts_by_method(const Sweep& sweep);

/// Outcomes in the order to be shown; those that no run should have are there only if one has.
std::vector<Outcome> shown_outcomes(const Sweep& sweep);

/// The shares of the outcomes, a line each, for a terminal.
std::vector<std::string> outcome_lines(const Sweep& sweep);

/// "44.6 %".
std::string share_in_words(long part, long whole);

/// What is wrong with a run, or empty.
std::string trouble_of(const SweepRun& run, double tolerance);

/// The command that repeats a run alone: "plumb solve cases/failure/random_sweep.toml --set …".
std::string command_of(const Sweep& sweep, const SweepRun& run);

}  // namespace plumb
