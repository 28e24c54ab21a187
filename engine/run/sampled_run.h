#pragma once

#include <map>
#include <string>
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
  /// Of what is read off a column up to each time, as "greatest tip.x": why there is no number, or no telling
  /// how far it is off; empty where there is.
  std::map<std::string, std::vector<std::string>> faults = {};
};

/// Samples a run of Plumb's own at times (s).
SampledRun sample(const Case& spec, const Trajectory& trajectory, const std::vector<double>& times);
SampledRun sample(const GivenRun& given, const std::vector<double>& times);

/// Takes modes by their numbers from a mode_table; between two there is nothing.
SampledRun sample_modes(const ProbeTable& modes, const std::vector<double>& numbers);

/// All that is compared of a run of Plumb's own at times (s) within it: the columns of its probes and what is
/// read off them up to each time, as "greatest tip.x".
ProbeTable compared_columns(const Case& spec, const Trajectory& trajectory,
                            const std::vector<Comparison>& compared, const std::vector<double>& times);

/// Adds what is read off columns of a run up to each time of its sample, with the difference that leaving out
/// every second output makes for its error. `outputs` are all that the run has; a column that it lacks is
/// left out.
void add_aggregates(const std::vector<Comparison>& compared, const ProbeTable& outputs, SampledRun& sampled);

/// The greatest share of a tolerance that an interpolation error may have in what is held against it.
inline constexpr double bearable_share = 0.1;

/// False for an error that cannot be told.
bool bearable(double interpolation_error, double tolerance);

}  // namespace plumb
