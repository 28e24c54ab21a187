#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/case/case.h"

namespace plumb {

/// What a fixed step does to a free vibration q'' = −ω² q, by theory: the spectral radius of the matrix that
/// takes (q, q') over one step, at z = ωh ≥ 0. Below 1 the vibration is damped, above it grows. Nothing for a
/// method that chooses its steps, and where its file does not say (MethodInfo::amplification).
std::optional<double> amplification(const MethodSpec& method, double z);

/// The greatest z = ωh below which no vibration grows: infinite for methods that are stable at every step; 0
/// where one grows at every step, however small. Nothing where there is no amplification.
std::optional<double> stability_limit(const MethodSpec& method);

/// Spectral radius of a matrix of two rows.
double radius_of_pair(const Eigen::Matrix2d& map);

/// That of a step that takes (q, v) to (q, v), by `step(q, v)` in place, where time is counted in steps: h =
/// 1 and ω = z. The map acts on (z q, v), so that a vibration is a circle.
template <class Step>
double radius_of_step(double z, const Step& step) {
  Eigen::Matrix2d map;
  for (int column = 0; column < 2; ++column) {
    double q = column == 0 ? 1 / z : 0, v = column;
    step(q, v);
    map.col(column) << z * q, v;
  }
  return radius_of_pair(map);
}

/// |1 + iz bᵀ (1 − iz A)⁻¹ (1, …, 1)|: the stability function of a Runge-Kutta method at iz (Hairer and
/// Wanner 1996, equation IV.3.2).
double runge_kutta_amplification(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double z);

}  // namespace plumb
