#pragma once

#include "engine/integrate/integrate.h"

namespace plumb {

/// How fast neighbouring motions part.
struct TrajectoryDivergence {
  double parameter = 0;
  int elements = 0;
  std::vector<double> times;      ///< s
  std::vector<double> distances;  ///< of two starts this far apart at first, m
  double exponent = 0;            ///< largest Lyapunov exponent, 1/s, over the longest duration
  double horizon = -1;            ///< time up to which a comparison to the tolerance means something, s
  bool beyond_end = false;        ///< the horizon is not reached within the longest duration
  std::string in_words;
};

/// How far apart two starts are that nobody could tell from one another, as a share of the length: about what
/// is left of the error of a tight integration.
inline constexpr double start_distance = 1e-10;

/// Follows a case to its end from two starts with a node `apart` (of the length) and the same steps of a
/// method of order 8, and finds when they are further apart than `tolerance` (m), and the largest Lyapunov
/// exponent by Benettin's renormalisation (Benettin et al. 1980). A motion that fails or takes longer than
/// `time_limit` (s) is followed as far as it goes; without any, times are empty and the horizon is -1.
TrajectoryDivergence divergence(const Case& spec, double parameter, double tolerance,
                                double apart = start_distance, double time_limit = no_time_limit);

}  // namespace plumb
