#pragma once

#include <string>
#include <vector>

#include "engine/run/run.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// How far an external run is from the run that is reported, in one column that both have: given minus
/// reported, at the times of both, each interpolated at those of the other.
struct GivenDistance {
  std::size_t given_run = 0;  ///< which [[run]] of the case
  std::string column;         ///< "tip.x"
  std::string unit;
  Coverage coverage;               ///< of the times of both
  std::vector<double> times;       ///< s, those that are compared
  std::vector<double> difference;  ///< in `unit`
  double max = 0;                  ///< greatest |difference|
  double max_time = 0;             ///< s, where it is
  double rms = 0;
  Magnitude scale;       ///< of all that either run has in that unit
  bool repeats = false;  ///< the numbers of one are among those of the other: it is one run
};

/// The distances of all external runs to the one that is reported.
std::vector<GivenDistance> given_distances(const Run& run);

/// A verdict for each of them that the case gives a tolerance for: verification, code against code.
std::vector<Verdict> distance_verdicts(const Run& run, const std::vector<GivenDistance>& distances);

/// "0.0123 m at 1.42 s (RMS 0.004 m), over 51 of 51 times from 0 to 1 s", or why there is none.
std::string in_words(const GivenDistance& distance);

}  // namespace plumb
