#pragma once

#include <string>

#include "engine/integrate/state.h"
#include "engine/integrate/trajectory.h"
#include "engine/model/cable.h"

namespace plumb {

/// What would help a run that ended with `outcome` at the state `last`, in one phrase: "a step below 1.04e-3
/// s, or an implicit method". Empty for completed.
std::string advice(const Cable& cable, const State& last, const MethodSpec& method, Outcome outcome);

}  // namespace plumb
