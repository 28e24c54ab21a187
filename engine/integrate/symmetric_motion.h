#pragma once

#include "engine/integrate/trajectory.h"

namespace plumb {

class Cable;

/// The earliest output (s) at which a cable that has kept to its straight line, as nothing in the case takes
/// it out of there, would leave it at the least disturbance; -1 where there is none. Looked for among some
/// outputs of `run`: across the line the tangent must have a mode that would grow more than a thousandfold
/// over the run, at no less than a quarter of them.
double unstable_since(const Cable& cable, const Trajectory& run);

}  // namespace plumb
