#pragma once

#include <string>

#include "engine/integrate/trajectory.h"

namespace plumb {

/// A run beside its reference on the same mesh, with the same outputs.
struct Judgement {
  Outcome outcome = Outcome::not_run;  ///< accurate or inaccurate for a run that completed, else its own
  double error = -1;         ///< greatest distance of a node over the outputs judged, m; -1: none judged
  double judged_until = -1;  ///< s; -1: not judged
};

/// Judges a run by its reference on the same mesh, with the same outputs, up to `horizon` (s), the time up to
/// which the reference can be trusted and neighbouring motions stay together. A run that goes beyond it is
/// also held to the energy: one that changes by more than `energy_share` of the first kinetic energy is
/// inaccurate. What is not a number is inaccurate; a completed run that cannot be held against the reference
/// stays completed, with an error of -1.
Judgement classify_outcome(const Trajectory& run, const Trajectory& reference, double tolerance,
                           double horizon);

/// For classify_outcome(), beyond the horizon.
inline constexpr double energy_share = 0.01;

}  // namespace plumb
