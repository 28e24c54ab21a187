#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/verdict/series_error.h"

namespace plumb {

/// What kind of evidence a verdict is. They are never mixed.
enum class VerdictKind {
  verification,  ///< against an exact or converged solution
  validation,    ///< against published figures, with their uncertainty stated
  regression,    ///< against this project's own earlier output
  performance,   ///< work against error
};

enum class VerdictStatus { not_run, passed, failed };

/// One criterion of a case and what became of it.
struct Verdict {
  VerdictKind kind = VerdictKind::verification;
  VerdictStatus status = VerdictStatus::not_run;
  std::string name;       ///< unique in a report: "published: mid.y", "chrono: published: mid.y"
  std::string criterion;  ///< "max |Plumb − published| of mid.y ≤ 1e-05 m"
  double value = -1;      ///< what was found, in `unit`; -1: not run
  double limit = 0;       ///< what is allowed, in `unit`
  std::string unit;
  std::optional<Coverage> coverage;  ///< of a comparison over time
  std::string detail;                ///< over how much, where the greatest is; or why it was not run
  std::string message;               ///< the outcome in words, with the numbers and the detail
  std::string reason;                ///< why this limit; may be empty
};

std::string_view word(VerdictKind);
std::string_view word(VerdictStatus);  ///< "not run", "passed", "failed"

/// A verdict for each comparison of the case: validation against published figures, verification against
/// computed ones, of the run that is reported and of each given one. Not run where the run did not complete,
/// is of another cable, or covers too little of what the case claims, or where a run that does nothing would
/// be within the tolerance.
std::vector<Verdict> verdicts(const Run& run, const std::vector<SeriesError>& errors);

/// Takes back that a distance passed where its limit is more than all that it is a distance from, and says so
/// where it is more than that moves. `of` is what has that scale: "the reference".
void hold_to_scale(Verdict& verdict, const Magnitude& scale, const std::string& of);

/// True for a distance that is a finite number of at least 0 and no greater than its limit.
bool within(double value, double limit);

bool all_passed(const std::vector<Verdict>& verdicts);

}  // namespace plumb
