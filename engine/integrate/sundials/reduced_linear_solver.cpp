#include "engine/integrate/sundials/reduced_linear_solver.h"

#include "engine/model/cable.h"

namespace plumb::sundials {

ReducedSystem::ReducedSystem(Dynamics& dynamics)
    : dynamics_(dynamics),
      q_(dynamics.size()),
      right_(dynamics.size()),
      momentum_(dynamics.size()),
      rates_(dynamics.size()) {}

int ReducedSystem::prepare(double t, N_Vector y, double gamma) {
  t_ = t;
  gamma_ = gamma;
  q_ = q_of(y, q_.size());
  return dynamics_.factor(q_, 1, gamma * gamma, {t, v_of(y, q_.size()).data()}, gamma) ? 1 : 0;
}

void ReducedSystem::solve(N_Vector solution, N_Vector right_hand_side) {
  const Eigen::Index n = q_.size();
  const auto b = q_of(right_hand_side, n), c = v_of(right_hand_side, n);
  right_ = b + gamma_ * c;
  dynamics_.cable().mass().multiply(right_, momentum_);
  rates_ = b;
  dynamics_.add_rate_product(t_, q_, rates_, gamma_, momentum_);
  dynamics_.cable().supports().apply(momentum_);
  dynamics_.solve(momentum_);
  // What the supports hold has x = b + γ w and w = c. Both are round-off there, but −b / γ is not.
  rates_ = c;
  dynamics_.cable().supports().apply(rates_);
  rates_ = c - rates_;
  momentum_ = (momentum_ - b) / gamma_;
  dynamics_.cable().supports().apply(momentum_);
  rates_ += momentum_;
  // `solution` may be the memory of the right-hand side.
  q_of(solution, n) = b + gamma_ * rates_;
  v_of(solution, n) = rates_;
}

}  // namespace plumb::sundials
