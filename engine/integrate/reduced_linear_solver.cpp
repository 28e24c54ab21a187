#include "engine/integrate/reduced_linear_solver.h"

#include <new>

namespace plumb::sundials {
namespace {

ReducedSystem& system_of(SUNLinearSolver solver) {
  return *static_cast<ReducedSystem*>(solver->content);
}

}  // namespace

int ReducedSystem::prepare(N_Vector y, double gamma) {
  gamma_ = gamma;
  q_ = q_of(y);
  return dynamics_.factor(q_, 1, gamma * gamma) ? 1 : 0;
}

void ReducedSystem::solve(N_Vector solution, N_Vector right_hand_side) {
  const auto b = q_of(right_hand_side), c = v_of(right_hand_side);
  right_ = b + gamma_ * c;
  dynamics_.cable().mass().multiply(right_, momentum_);
  dynamics_.cable().supports().apply(momentum_);
  dynamics_.solve(momentum_);
  // Both vectors may be the same memory.
  v_of(solution) = (momentum_ - b) / gamma_;
  q_of(solution) = momentum_;
}

Matrix ReducedSystem::make_matrix(const Context& context) {
  Matrix matrix(SUNMatNewEmpty(context));
  if (!matrix) throw std::bad_alloc();
  matrix->content = this;
  matrix->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  matrix->ops->destroy = [](SUNMatrix self) { SUNMatFreeEmpty(self); };
  // The numbers are made by `prepare` alone, so there is nothing to clear.
  matrix->ops->zero = [](SUNMatrix) { return 0; };
  return matrix;
}

LinearSolver ReducedSystem::make_solver(const Context& context) {
  LinearSolver solver(SUNLinSolNewEmpty(context));
  if (!solver) throw std::bad_alloc();
  solver->content = this;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  solver->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  solver->ops->initialize = [](SUNLinearSolver) { return static_cast<int>(SUNLS_SUCCESS); };
  // `prepare` has factored the matrix already.
  solver->ops->setup = [](SUNLinearSolver, SUNMatrix) { return static_cast<int>(SUNLS_SUCCESS); };
  solver->ops->solve = [](SUNLinearSolver self, SUNMatrix, N_Vector x, N_Vector b, double) {
    system_of(self).solve(x, b);
    return static_cast<int>(SUNLS_SUCCESS);
  };
  solver->ops->free = [](SUNLinearSolver self) {
    SUNLinSolFreeEmpty(self);
    return static_cast<int>(SUNLS_SUCCESS);
  };
  return solver;
}

}  // namespace plumb::sundials
