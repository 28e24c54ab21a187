#pragma once

#include <vector>

#include "engine/base/known_time.h"
#include "engine/integrate/trajectory.h"
#include "engine/read/given_probes.h"

namespace plumb {

/// What a run knows of some times: a row for each that is not outside its outputs.
struct SampledRun {
  std::vector<std::size_t> rows;  ///< places of these times among those that were asked for
  std::vector<KnownTime> times;
  ProbeTable values;  ///< at `times`, between outputs interpolated
  /// How far a value may be off, being interpolated; 0 at an output. It is the greatest difference that
  /// leaving out every second output makes at those next to the time, across gaps about twice as long, so
  /// that it is more than the error itself where the motion is smooth. Not a number where it cannot be told:
  /// with fewer than `fewest_outputs`, and farther from an output than the `tried_distance`.
  ProbeTable errors;
  /// Outputs are equilibria, between which nothing is known: the errors there are not numbers.
  bool between_is_unknown = false;
};

/// Samples a run of Plumb's own at times (s).
SampledRun sample(const Case& spec, const Trajectory& trajectory, const std::vector<double>& times);
SampledRun sample(const GivenRun& given, const std::vector<double>& times);

/// Takes modes by their numbers from a mode_table; between two there is nothing.
SampledRun sample_modes(const ProbeTable& modes, const std::vector<double>& numbers);

/// The greatest share of a tolerance that an interpolation error may have in what is held against it.
inline constexpr double bearable_share = 0.1;

/// False for an error that cannot be told.
bool bearable(double interpolation_error, double tolerance);

}  // namespace plumb
