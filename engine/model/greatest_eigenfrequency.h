#pragma once

#include <Eigen/Core>

#include "engine/model/cable.h"

namespace plumb {

/// The fastest vibration of a cable about a state, with its supports: the greatest ω of K(q) φ = ω² M φ.
struct FastestVibration {
  double frequency = 0;   ///< ω, rad/s; 0: nothing vibrates
  Eigen::VectorXd shape;  ///< φ, with φᵀ M φ = 1
  int element = 0;        ///< where it is greatest
};

/// By Lanczos's method on the banded pair; no matrix is ever dense.
FastestVibration fastest_vibration(const Cable& cable, const Eigen::VectorXd& q);

}  // namespace plumb
