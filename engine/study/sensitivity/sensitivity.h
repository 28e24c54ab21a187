#pragma once

#include <string>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/run/provenance.h"
#include "engine/study/sensitivity/planned_blunders.h"
#include "engine/study/sensitivity/smallest_change.h"

namespace plumb {

/// A criterion of a case with what it finds of the case as it is.
struct JudgedCriterion {
  std::string name;  ///< unique: "published: tip.z"
  std::string unit;
  double limit = 0;   ///< in `unit`
  double value = -1;  ///< in `unit`; -1: it could not be judged
  bool met = false;   ///< otherwise it has nothing to lose, and is not asked what it notices
};

/// A number of the model, with what the criteria notice of it.
struct NumberSensitivity {
  std::string key;    ///< "cable.density"
  std::string words;  ///< "density"
  SearchedSide up, down;

  /// False where no changed run ended in the time that it had.
  bool told() const { return up.searched > 0 || down.searched > 0; }
};

/// A blunder, with what the criteria make of it.
struct BlunderSensitivity {
  PlannedBlunder blunder;
  Trial trial;

  bool applies() const { return blunder.why_not.empty(); }
};

/// Which mistakes the criteria of a case notice.
struct Sensitivity {
  double largest = 0;     ///< factor up to which numbers were changed, and share down to which
  double time_limit = 0;  ///< of one run, s
  std::string left_out;   ///< why nothing was tried; empty: it was
  std::vector<JudgedCriterion> criteria;
  std::vector<NumberSensitivity> numbers;
  std::vector<BlunderSensitivity> blunders;
  int runs = 0;         ///< that were made for it
  double seconds = -1;  ///< they took, by the clock

  /// How many numbers a criterion notices that are wrong by a factor of two or less, and how many blunders.
  /// That a run fails and that a finer mesh is seen says nothing for it.
  long noticed_numbers(std::size_t criterion) const;
  long noticed_blunders(std::size_t criterion) const;
  /// False where no changed run ended in the time that it had, so that nothing is known.
  bool told() const;
  /// A criterion that is met and notices none of either, where something could be told.
  bool weak(std::size_t criterion) const;
  std::vector<std::string> weak_names() const;
};

/// A case with that.
struct SensitivityStudy {
  LoadedCase loaded;
  Sensitivity result;
  Provenance provenance;
};

}  // namespace plumb
