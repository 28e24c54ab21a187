#pragma once

#include <algorithm>
#include <cmath>

#include "engine/case/case.h"
#include "engine/integrate/method.h"
#include "engine/model/cable.h"

namespace plumb {

/// The meaning of newton_tolerance to a method that integrates over time.
inline constexpr const char* newton_tolerance_meaning =
    "largest error that the iteration adds to a position by the end of the run, as a fraction of the cable's "
    "length";

/// What Newton's iteration may leave of an error in position, or of a slope times the element length, in a
/// step of the length that `spec` gives, m: so little that all steps together add no more than
/// newton_tolerance to the end. Mostly it is left in vibrations, so that what is left in one step has no sign
/// in common with what is left in the next, and the sum grows as the root of their number. `weight`: how much
/// more of it the method carries on than a one-step method of one stage does. Where steps are chosen, their
/// tolerance bounds the sum.
inline double leftover_of_a_step(const MethodSpec& spec, const Dynamics& dynamics, double weight = 1) {
  constexpr double round_off = 1e-15;  // of the length
  const double length = dynamics.cable().length(), added = spec.parameters.at("newton_tolerance") * length;
  if (!spec.step) return added;
  const double steps = std::max(1.0, dynamics.times().duration / *spec.step);
  return std::max(added / (weight * std::sqrt(steps)), std::min(added, round_off * length));
}

}  // namespace plumb
