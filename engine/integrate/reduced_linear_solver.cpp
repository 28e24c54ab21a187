#include "engine/integrate/reduced_linear_solver.h"

namespace plumb::sundials {

ReducedSystem::ReducedSystem(Dynamics& dynamics)
    : dynamics_(dynamics), q_(dynamics.size()), right_(dynamics.size()), momentum_(dynamics.size()) {}

int ReducedSystem::prepare(N_Vector y, double gamma, bool reuse_tangent) {
  gamma_ = gamma;
  if (reuse_tangent) return dynamics_.refactor(1, gamma * gamma) ? 1 : 0;
  q_ = q_of(y, q_.size());
  return dynamics_.factor(q_, 1, gamma * gamma) ? 1 : 0;
}

void ReducedSystem::solve(N_Vector solution, N_Vector right_hand_side) {
  const Eigen::Index n = q_.size();
  const auto b = q_of(right_hand_side, n), c = v_of(right_hand_side, n);
  right_ = b + gamma_ * c;
  dynamics_.cable().mass().multiply(right_, momentum_);
  dynamics_.cable().supports().apply(momentum_);
  dynamics_.solve(momentum_);
  // Rates first: `solution` may be the memory that b lies in.
  v_of(solution, n) = (momentum_ - b) / gamma_;
  q_of(solution, n) = momentum_;
}

}  // namespace plumb::sundials
