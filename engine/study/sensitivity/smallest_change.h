#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/integrate/trajectory.h"

namespace plumb {

/// What one criterion found of a run.
struct Found {
  double value = -1;  ///< in the unit of the criterion; -1: it could not be judged
  bool noticed = false;
};

/// A run with something changed, as the criteria saw it.
struct Trial {
  Outcome outcome = Outcome::not_run;  ///< `not_run`: there is no such case
  std::string message;                 ///< why it did not complete, or was not run
  std::vector<Found> found;            ///< one a criterion where it completed, else none

  /// Nothing follows from it: there is no such case, or the run took too long.
  bool untold() const { return outcome == Outcome::not_run || outcome == Outcome::out_of_time; }
  /// A run that fails is noticed by all.
  bool failed() const { return outcome != Outcome::completed && !untold(); }
  bool notices(std::size_t criterion) const { return failed() || (!untold() && found[criterion].noticed); }
};

/// The smallest change of a number that one criterion was found to notice.
struct NoticedChange {
  double change = -1;       ///< c > 0 of the factor 1 + c, or 1/(1 + c) downwards; -1: it notices none
  bool by_failure = false;  ///< as the run does not complete there
};

/// What came of a search in one direction.
struct SearchedSide {
  int runs = 0;
  double searched = 0;  ///< up to which change something could be told
  std::string ended;    ///< why no further, where that is less than was asked for; empty: it is not
  std::vector<NoticedChange> noticed;  ///< one a criterion
};

/// The smallest change that is noticed, for each criterion that is `wanted`: bracketed from 1 % outwards in
/// steps that grow, or inwards by tenths, and halved in its logarithm until it is known to 5 %. A criterion
/// that is noticed here and there is bracketed where it first is. All share the trials. `largest` > 0.
SearchedSide smallest_changes(const std::vector<bool>& wanted, double largest,
                              const std::function<Trial(double change)>& trial);

}  // namespace plumb
