#pragma once

#include <Eigen/Core>

namespace plumb {

class Cable;
struct Case;

/// The fastest vibration of a cable about a state, with its supports: the greatest ω of K(q) φ = ω² M φ.
struct FastestVibration {
  double frequency = 0;   ///< ω, rad/s; 0: nothing vibrates, or K is not finite
  Eigen::VectorXd shape;  ///< φ, with φᵀ M φ = 1
  int element = 0;        ///< where it is greatest, from 0
};

/// By Lanczos's method on the banded pair (Parlett 1998, chapter 13); time and memory are linear in the
/// number of elements. ω is good to 1e-6 where the vibration is gathered somewhere, as it is at a free end,
/// and to 1e-3 at worst, along a fine and even cable held at both ends.
FastestVibration fastest_vibration(const Cable& cable, const Eigen::VectorXd& q);

/// The ω of a case's cable at its start, rad/s; 0 of a rigid rod.
double fastest_frequency_at_start(const Case& spec);

}  // namespace plumb
