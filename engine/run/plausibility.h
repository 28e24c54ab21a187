#pragma once

#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// What of a case is not as anything is that is built: densities, stresses, thickness, steps that the fastest
/// vibration does not bear, and too few output times; a sentence each. Nothing of it is refused, as a model
/// may be of anything.
std::vector<std::string> implausible_inputs(const Case& spec);

/// A stress at an output of a finished run that no material bears; empty: there is none.
std::string implausible_stress(const Case& spec, const Trajectory& run);

/// Of an explicit method that chose its steps, where stability rather than its tolerance kept them short: how
/// many steps an implicit one with the same tolerances took, which is tried here in no more time than the run
/// took. Empty where that is not so.
std::string held_back_by_stability(const Case& spec, const Trajectory& run);

}  // namespace plumb
