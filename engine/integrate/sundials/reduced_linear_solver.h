#pragma once

#include "engine/integrate/sundials/library_linear_solver.h"

namespace plumb::sundials {

/// The library's Newton system (I − γJ) (x, w) = (b, c) for q' = v, v' = M⁻¹ f(q), reduced to the block
/// banded matrix of half its size: with K = −∂f/∂q,
///   (M + γ C + γ² K) x = M (b + γ c) + γ C b,   w = (x − b) / γ,   C = −∂f/∂v.
/// Nothing dense and no general sparse matrix is formed.
class ReducedSystem : public LinearSystem {
 public:
  explicit ReducedSystem(Dynamics& dynamics);

  /// Prepares the matrix at t (s) and y. Returns 1 if the matrix is singular (the library tries a shorter
  /// step), else 0.
  int prepare(double t, N_Vector y, double gamma);

  void solve(N_Vector solution, N_Vector right_hand_side) override;

 private:
  Dynamics& dynamics_;
  double t_ = 0, gamma_ = 0;
  Eigen::VectorXd q_, right_, momentum_, rates_;
};

}  // namespace plumb::sundials
