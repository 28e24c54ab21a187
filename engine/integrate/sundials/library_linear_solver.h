#pragma once

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include "engine/integrate/sundials/library_method.h"

namespace plumb::sundials {

struct DestroyMatrix {
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
};
using Matrix = std::unique_ptr<_generic_SUNMatrix, DestroyMatrix>;

struct DestroyLinearSolver {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};
using LinearSolver = std::unique_ptr<_generic_SUNLinearSolver, DestroyLinearSolver>;

/// A linear system of one of the library's Newton iterations whose structure is known here. It is prepared by
/// the callback in which the library asks for the matrix.
class LinearSystem {
 public:
  virtual ~LinearSystem() = default;

  /// The solution for a right-hand side; both may be the same memory.
  virtual void solve(N_Vector solution, N_Vector right_hand_side) = 0;
};

/// A matrix without numbers: what the library hands around in place of one.
Matrix make_matrix(const Context& context);

/// A direct solver that calls `system`, which must outlive it.
LinearSolver make_solver(LinearSystem& system, const Context& context);

}  // namespace plumb::sundials
