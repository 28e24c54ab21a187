#pragma once

#include <string>

#include "engine/integrate/state.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

class Cable;
struct MethodSpec;

/// What would help a run from `start` that ended with `outcome` after the outputs that `run` holds, in one
/// phrase: "a step below 0.00104 s, or an implicit method". The step is that below which the fastest
/// vibration of the start and of the outputs that can still be believed does not grow (stability_limit).
/// Empty for a run that did not fail. Takes about a second for the finest meshes, and far less for others.
std::string advice(const Cable& cable, const State& start, const Trajectory& run, const MethodSpec& method,
                   Outcome outcome);

}  // namespace plumb
