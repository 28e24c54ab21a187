#pragma once

#include <functional>
#include <string>

#include "engine/integrate/state.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

class Cable;
struct MethodSpec;

/// Runs a case anew with another method, within a bounded time, and says how far it came: "to the end",
/// "to 2.1 s"; empty where it failed as well, or came no further.
using Attempt = std::function<std::string(const MethodSpec&)>;

/// What would help a run from `start` that ended with `outcome` after the outputs that `run` holds, in one
/// phrase: "a step below 0.00104 s (tried to the end), or an implicit method". The first step to be named is
/// that below which the fastest vibration of the start and of the outputs that can still be believed does not
/// grow (stability_limit). With an `attempt` steps, tolerances and methods are tried before they are named;
/// where none helps, it is said what was tried. Empty for a run that did not fail. Without an `attempt` it
/// takes about a second for the finest meshes, and far less for others.
std::string advice(const Cable& cable, const State& start, const Trajectory& run, const MethodSpec& method,
                   Outcome outcome, const Attempt& attempt = {});

}  // namespace plumb
