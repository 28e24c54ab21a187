#pragma once

#include "engine/integrate/integrate.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// How two steps that enclose a limit may differ, as a fraction.
inline constexpr double critical_step_share = 0.01;

/// Finds the step between stable and not for a case run to its end by a method with a fixed step (`method`
/// without one), by bisection to 1 % from a bracket around the predicted step. A run that completes is
/// stable; where the prediction rests on a vibration it must also gain no more than `energy_share` of the
/// first kinetic energy, as a vibration that grows can be caught by the nonlinear forces, finite and wrong.
/// Each run may take `time_limit` (s); one that would take longer ends the search with what is known.
/// `parameter` is left to the caller. Throws std::invalid_argument for a method that takes no step.
CriticalStep critical_step(const Case& spec, const MethodSpec& method, double time_limit = no_time_limit);

}  // namespace plumb
