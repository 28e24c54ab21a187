#pragma once

#include "engine/case/case.h"

namespace plumb {

/// A guess at the fastest vibration of the straight cable, rad/s: 9.55 c/l along it, with c the speed of
/// sound and l the length of an element, or √8400 c_b/l² across it, as a free element has it with c_b =
/// sqrt(EI/ρA). No eigenproblem is solved for it.
double straight_frequency(const CableSpec& cable);

}  // namespace plumb
