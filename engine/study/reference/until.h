#pragma once

#include "engine/integrate/trajectory.h"

namespace plumb {

/// A run as it would have been, had it ended at `end` (s): its outputs up to there, and completed where it
/// got that far. What it cost is not known, unless it is the whole run.
Trajectory until(const Trajectory& run, double end);

}  // namespace plumb
