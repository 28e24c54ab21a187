#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/case/report_specs.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// How far a changed computation is from the base of a budget in one series.
struct BudgetDistance {
  double at_reference = -1;       ///< greatest over the times of the reference, in its unit; -1: none
  double at_reference_time = -1;  ///< s, where that is
  double sampled = -1;            ///< greatest over every `ErrorBudget::interval`; -1: not asked for, or none
  double sampled_time = -1;       ///< s
};

/// How far a computation is from others in one series.
struct SeriesDistance {
  std::string series;                       ///< "mid_y"
  double from_reference = -1;               ///< greatest over the times of the reference; -1: none
  std::optional<BudgetDistance> from_base;  ///< nothing of the base itself
  /// This run minus the base at ErrorBudget::times; none of the base itself.
  std::vector<double> difference;
};

/// A computation of a budget and how it went.
struct BudgetRun {
  std::vector<std::string> overrides;  ///< after those of the case
  Outcome outcome = Outcome::not_run;
  std::string message;  ///< why it did not complete
  std::string method;   ///< in words: "rk4, step 5e-05 s"
  int elements = 0;
  double seconds = -1;                    ///< of the time loop
  std::vector<SeriesDistance> distances;  ///< one a series where it completed, else none

  bool completed() const { return outcome == Outcome::completed; }
};

/// One thing that is changed, and the run with it alone.
struct BudgetEntry {
  std::string name;
  std::string reason;
  bool together = true;
  bool numerical = false;  ///< an error of the published computation's own numerics
  bool of_mesh = false;    ///< it changes the number of elements
  bool of_run = false;  ///< but for its method the run that is reported has it, and the published one has not
  BudgetRun run;
};

struct BudgetSeries {
  std::string series;       ///< "mid_y"
  std::string column;       ///< "mid.y"
  std::string description;  ///< of the reference
  std::string unit;
};

/// What each of the things in which a published computation differs from the exact one moves its series by.
struct ErrorBudget {
  std::string reference;      ///< name of the [[reference]]
  std::string left_out;       ///< why nothing was computed; empty: all was
  double interval = 0;        ///< s; 0: distances at the times of the reference only
  std::vector<double> times;  ///< s, those of the reference within the run
  std::vector<BudgetSeries> series;
  BudgetRun base;
  std::vector<BudgetEntry> entries;
  BudgetRun together;   ///< all entries but those for information
  double seconds = -1;  ///< it took, by the clock
};

}  // namespace plumb
