#pragma once

#include <vector>

#include "engine/run/run.h"

namespace plumb {

/// Times of a reference, and their rows in it.
struct ComparableTimes {
  std::vector<std::size_t> rows;
  std::vector<double> times;  ///< s
};

/// The times of a reference within what the case claims, at which every column that is compared is known of a
/// run of Plumb's own: as an output, as which the run has it, or interpolated well enough for the tolerance.
ComparableTimes comparable_times(const Run& run, const ReferenceUse& use, const Reference& reference);

}  // namespace plumb
