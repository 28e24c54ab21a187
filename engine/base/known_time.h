#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace plumb {

/// Where a time lies among the outputs of a run.
struct KnownTime {
  double time = 0;         ///< s; at an output, as the run has it
  bool output = false;     ///< it is an output, but for rounding
  std::size_t before = 0;  ///< that output, or the last one before
  double distance = 0;     ///< s, to the nearest output; 0 at one
};

/// Nothing for a time (s) outside the outputs, which rise strictly, by more than rounding.
std::optional<KnownTime> known_time(const std::vector<double>& outputs, double t);

/// The fewest outputs that can tell how well they are interpolated: of every two one left out, four remain.
inline constexpr std::size_t fewest_outputs = 8;

/// The outputs, up to two on either side, that are left out to tell how well a run is interpolated about a
/// time. None at an output, and where there are too few.
std::vector<std::size_t> tried_outputs(const std::vector<double>& outputs, const KnownTime& at);

/// How far from an output (s) interpolation was tried by leaving out those next to a time; 0: not at all.
double tried_distance(const std::vector<double>& outputs, const KnownTime& at);

}  // namespace plumb
