#pragma once

#include <optional>

#include "engine/integrate/methods/structural_method.h"

namespace plumb {

/// The scheme of each structural method, defined in its own file.
StructuralScheme implicit_euler_scheme();
StructuralScheme trapezoidal_scheme();
StructuralScheme hht_scheme(double alpha);
StructuralScheme generalized_alpha_scheme(double spectral_radius, bool mean_forces);
StructuralScheme implicit_midpoint_scheme();

/// The scheme of the method that `spec` names; nothing for a method that has none. On a linear vibration the
/// discrete gradient is the gradient at the midpoint, so that `energy-momentum` has that of the midpoint
/// rule.
std::optional<StructuralScheme> structural_scheme(const MethodSpec& spec);

}  // namespace plumb
