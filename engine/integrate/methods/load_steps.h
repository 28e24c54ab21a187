#pragma once

#include <memory>

#include "engine/integrate/method.h"

namespace plumb {

/// Equilibria under loads that change with the share of the run in more than their size, or with how the
/// cable lies, so that no path of them is followed: one load step after the other, each from the equilibrium
/// before it. Takes the parameters of `statics`, but for where a path is followed to.
std::unique_ptr<Method> make_load_steps(const MethodSpec& spec, Dynamics& dynamics, const State& start);

}  // namespace plumb
