#pragma once

#include <optional>

#include "engine/case/case.h"

namespace plumb {

/// What a fixed step does to a free vibration q'' = −ω² q, by theory: the spectral radius of the matrix that
/// takes (q, q') over one step, at z = ωh ≥ 0. Below 1 the vibration is damped, above it grows. Nothing for a
/// method that chooses its steps.
std::optional<double> amplification(const MethodSpec& method, double z);

/// The greatest z = ωh below which no vibration grows: 2 for velocity-verlet, 2√2 for rk4, infinite for
/// methods that are stable at every step; 0 where one grows at every step, however small. Nothing for a
/// method that chooses its steps.
std::optional<double> stability_limit(const MethodSpec& method);

}  // namespace plumb
