#pragma once

#include "engine/integrate/method.h"

namespace plumb {

/// A rigid rod on a joint at its first end (CableModel::rigid), without spin about its own axis. With its
/// direction d, length L and mass per length m,
///   d̈ = a − (a·d) d − (ḋ·ḋ) d,  a = Q / (m L³/3),
/// with M s² of each mass M at a length s along it beside m L³/3, where Q is the work of the loads and of
/// damping per change of d: the spherical pendulum (Landau and Lifshitz, Mechanics, § 14). It is integrated
/// by rk4 with a fixed step; after each step d is a unit vector again, and ḋ at right angles to it. States
/// are those of the straight cable's nodes. Without a step in `spec`, std::invalid_argument.
std::unique_ptr<Method> make_rigid_rod(const MethodSpec& spec, Dynamics& dynamics, const State& start);

}  // namespace plumb
