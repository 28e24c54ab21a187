#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "engine/model/lowest_modes.h"

namespace plumb {

/// A solution φ exp(λt) of M ẍ + D ẋ + K x = 0.
struct ComplexMode {
  std::complex<double> exponent;  ///< λ, 1/s, with an imaginary part ≥ 0
  Eigen::VectorXcd shape;         ///< φ, with φ* M φ = 1
  double damping_ratio = 0;       ///< of aλ² + bλ + c = 0 with a = φ* M φ, b = φ* D φ and c = φ* K φ
  bool rigid_body = false;
  double residual = 0;  ///< as VibrationMode has it
};

/// Modes with the rates' part of small motions and all of K.
struct ComplexModes {
  std::vector<ComplexMode> modes;  ///< growing ones first, then rigid-body motions, then by |λ|
  std::string failure;             ///< why there are not as many as were asked for; empty: there are
};

/// The first `count` modes: those of the system projected on the undamped modes at rest, of which more are
/// taken than are asked for, and from each of these by Newton's iteration on the whole of it, in which λ² M +
/// λ D + K is factored (Güttel and Tisseur 2017, section 4.2). Of the two real exponents of an overdamped
/// mode the slower one is given. Throws Interrupted.
ComplexModes complex_modes(const SmallMotions& motions, int count);

}  // namespace plumb
