#pragma once

#include <optional>

#include "engine/integrate/method_info.h"
#include "engine/integrate/trajectory.h"
#include "engine/study/stability/stability.h"

namespace plumb {

class Cable;

/// That of the method; nothing for methods that are not structural or have no Newton iteration.
std::optional<NewtonMatrix> newton_matrix(const MethodSpec& method);

/// How much one iteration leaves of an error near the solution when the matrix is that of another state: the
/// spectral radius of I − S(q)⁻¹ S(q*) with step h (s), by power iteration on the banded matrices (Hairer and
/// Wanner 1996, section IV.8). Infinite where S(q) is singular. Below `roughly` it is found to a tenth only,
/// which takes far fewer iterations.
double newton_contraction(const Cable& cable, const NewtonMatrix& matrix, double h, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& q_solution, double roughly = 0);

/// The step (s) from which on the iteration with the matrix of the state before the step contracts no longer,
/// at the start and where it is shortest along a reference motion with closely spaced outputs. Infinite where
/// it contracts with every step up to the motion's end. -1 for a method without newton_matrix().
/// An estimate, not a limit: methods here renew their matrix within a step. On the pendulum of four elements
/// over 2 s, f = 1 and 5, the trapezoidal rule fails from 5 to 8 % above the start's value; generalized-alpha
/// with strong damping (0.5) lasts to 4 to 6 times it, and undamped it gains energy before, from a quarter to
/// two thirds of it. The worst value is 2 to 3 times shorter than the start's, and too cautious.
PredictedLimit contraction_limit(const Cable& cable, const MethodSpec& method, const Trajectory& motion);

}  // namespace plumb
