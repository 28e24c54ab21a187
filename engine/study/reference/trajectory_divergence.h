#pragma once

#include "engine/integrate/integrate.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// How far apart two starts are that nobody could tell from one another, m: about what is left of the error
/// of a tight integration.
inline constexpr double start_distance = 1e-10;

/// Follows a case to its end from two starts with a node `apart` (m) and the same steps of a method of order
/// 8, and finds when they are further apart than `tolerance` (m), and the largest Lyapunov exponent by
/// Benettin's renormalisation (Benettin et al. 1980). A motion that fails or takes longer than `time_limit`
/// (s) is followed as far as it goes; without any, times are empty and the horizon is -1.
Separation separation(const Case& spec, double parameter, double tolerance, double apart = start_distance,
                      double time_limit = no_time_limit);

}  // namespace plumb
