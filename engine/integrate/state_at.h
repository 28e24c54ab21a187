#pragma once

#include "engine/integrate/state.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// Cubic Hermite interpolation of q at t from q and v at both ends of an interval, and of v from its
/// derivative. `to` may not be one of the ends.
void hermite_in_time(const State& before, const State& after, double t, State& to);

/// The state of a trajectory at t (s): that of an output within 1e-9 of its interval, else interpolated
/// between the two around it. Throws std::out_of_range for a time outside the outputs.
State state_at(const Trajectory& trajectory, double t);

}  // namespace plumb
