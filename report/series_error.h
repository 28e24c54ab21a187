#pragma once

#include <string>
#include <vector>

#include "engine/output/run.h"

namespace plumb {

/// How far one column of a run is from one series of a reference. Distances are in `unit`, run minus
/// reference.
struct SeriesError {
  std::size_t reference = 0;  ///< which [[reference]] of the case
  std::string series;         ///< "mid_y"
  std::string column;         ///< "mid.y"
  std::string unit;
  std::vector<double> times;       ///< s, the reference times that the run reached
  std::vector<double> expected;    ///< of the reference, at those times
  std::vector<double> difference;  ///< run − reference, at those times
  std::size_t missed = 0;          ///< reference times within the case's end that the run did not reach
  std::size_t interpolated = 0;    ///< of `times`, those between two outputs of the run
  double max = 0;                  ///< greatest |difference|
  double max_time = 0;             ///< s, where it is
  double rms = 0;
};

/// The errors of every comparison of the case, in its order.
std::vector<SeriesError> series_errors(const Run& run);

}  // namespace plumb
