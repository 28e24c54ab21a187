#include "engine/integrate/sundials/library_linear_solver.h"

#include <new>

namespace plumb::sundials {

Matrix make_matrix(const Context& context) {
  Matrix matrix(SUNMatNewEmpty(context));
  if (!matrix) throw std::bad_alloc();
  matrix->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  matrix->ops->destroy = [](SUNMatrix self) { SUNMatFreeEmpty(self); };
  matrix->ops->zero = [](SUNMatrix) { return 0; };
  return matrix;
}

LinearSolver make_solver(LinearSystem& system, const Context& context) {
  LinearSolver solver(SUNLinSolNewEmpty(context));
  if (!solver) throw std::bad_alloc();
  solver->content = &system;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  solver->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  solver->ops->initialize = [](SUNLinearSolver) { return static_cast<int>(SUNLS_SUCCESS); };
  // The system was factored when the library asked for the matrix.
  solver->ops->setup = [](SUNLinearSolver, SUNMatrix) { return static_cast<int>(SUNLS_SUCCESS); };
  solver->ops->solve = [](SUNLinearSolver self, SUNMatrix, N_Vector x, N_Vector b, double) {
    static_cast<LinearSystem*>(self->content)->solve(x, b);
    return static_cast<int>(SUNLS_SUCCESS);
  };
  solver->ops->free = [](SUNLinearSolver self) {
    SUNLinSolFreeEmpty(self);
    return static_cast<int>(SUNLS_SUCCESS);
  };
  return solver;
}

}  // namespace plumb::sundials
