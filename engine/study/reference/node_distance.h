#pragma once

#include "engine/integrate/trajectory.h"

namespace plumb {

/// Greatest distance of a node between two runs of one mesh over the outputs up to `until` (s), m. -1 where
/// meshes or times differ or there are none; infinite where one is not a number.
double node_distance(const Trajectory& a, const Trajectory& b, double until);

/// The last output up to which no node of one run is further than `apart` (m) from the other's, s. -1: none.
double together_until(const Trajectory& a, const Trajectory& b, double apart);

}  // namespace plumb
