#pragma once

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include "engine/integrate/library_method.h"

namespace plumb::sundials {

struct DestroyMatrix {
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
};
using Matrix = std::unique_ptr<_generic_SUNMatrix, DestroyMatrix>;

struct DestroyLinearSolver {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};
using LinearSolver = std::unique_ptr<_generic_SUNLinearSolver, DestroyLinearSolver>;

/// The library's Newton system (I − γJ) (x, w) = (b, c) for q' = v, v' = M⁻¹ f(q), reduced to the block
/// banded matrix of half its size: with K = −∂f/∂q,
///   (M + γ² K) x = M (b + γ c),   w = (x − b) / γ.
/// Nothing dense and no general sparse matrix is formed. One object serves as the user data of matrix and
/// solver.
class ReducedSystem {
 public:
  explicit ReducedSystem(Dynamics& dynamics) : dynamics_(dynamics) {}

  /// Prepares M + γ² K at y. Returns 1 if the matrix is singular (the library tries a shorter step), else 0.
  int prepare(N_Vector y, double gamma);

  /// (x, w) for the right-hand side (b, c).
  void solve(N_Vector solution, N_Vector right_hand_side);

  /// The library's wrappers, which refer to this object.
  Matrix make_matrix(const Context& context);
  LinearSolver make_solver(const Context& context);

 private:
  Dynamics& dynamics_;
  double gamma_ = 0;
  Eigen::VectorXd q_, right_, momentum_;
};

}  // namespace plumb::sundials
