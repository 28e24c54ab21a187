#pragma once

#include <array>
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

enum class VerdictStatus {
  not_run,
  passed,
  failed,
  another_model,  ///< held against figures of another model: shown, and neither passed nor failed
};

/// All of them, those that are to be read first in front.
inline constexpr std::array statuses_by_urgency{VerdictStatus::failed, VerdictStatus::not_run,
                                                VerdictStatus::another_model, VerdictStatus::passed};

/// Place among those.
int urgency(VerdictStatus status);

/// One criterion of a case and what became of it.
struct Verdict {
  VerdictKind kind = VerdictKind::verification;
  VerdictStatus status = VerdictStatus::not_run;
  /// unique in a report: "published: mid.y", "published: exact: mid.y", "chrono: published: mid.y"
  std::string name;
  std::string criterion;  ///< "max |Plumb − published| of mid.y ≤ 1e-05 m"
  double value = -1;      ///< what was found, in `unit`; -1: not run
  double limit = 0;       ///< what is allowed, in `unit`
  std::string unit;
  std::optional<Coverage> coverage;  ///< of a comparison over time
  std::string detail;                ///< over how much, where the greatest is; or why it was not run
  std::string message;               ///< the outcome in words, with the numbers and the detail
  std::string reason;                ///< why this limit; may be empty
  double time = -1;                  ///< s, where the value was found; -1: of no one time
};

std::string_view word(VerdictKind);
std::string_view word(VerdictStatus);  ///< "not run", "passed", "failed", "another model"

/// A verdict for each of `errors`, those of the run that is reported and of each given one: validation
/// against published figures, verification against computed and exact ones. Where there are exact ones, a
/// published figure is allowed to be off by as much as it is from them. Not run where the run did not
/// complete, is of another cable, or covers too little of what the case claims, or where a run that does
/// nothing would be within the tolerance.
std::vector<Verdict> verdicts(const Run& run, const std::vector<SeriesError>& errors);

/// Takes back that a distance passed where its limit is more than all that it is a distance from, and says so
/// where it is more than that moves. `of` is what has that scale: "the reference".
void hold_to_scale(Verdict& verdict, const Magnitude& scale, const std::string& of);

/// True for a distance that is a finite number of at least 0 and no greater than its limit.
bool within(double value, double limit);

long count_of(const std::vector<Verdict>& verdicts, VerdictStatus status);

/// True where none failed or was not run; those against another model do not count.
bool all_passed(const std::vector<Verdict>& verdicts);

/// True where, beside that, one passed.
bool all_met(const std::vector<Verdict>& verdicts);

}  // namespace plumb
