#include "engine/integrate/sundials/ida_linear_system.h"

#include "engine/model/cable.h"

namespace plumb::sundials {

IdaLinearSystem::IdaLinearSystem(Dynamics& dynamics, const SupportConstraints& constraints, bool stabilised)
    : dynamics_(dynamics),
      constraints_(constraints),
      stabilised_(stabilised),
      free_system_(dynamics.cable().nodes()) {
  for (Eigen::VectorXd* x : {&q_, &dq_, &z_, &r_, &rates_, &product_}) x->resize(dynamics.size());
}

int IdaLinearSystem::prepare(double t, N_Vector y, double leading) {
  t_ = t;
  c_ = leading;
  q_ = q_of(y, dq_.size());
  // With a factor of c² at the mass, held rows would be judged singular beside it for short steps.
  const double stiffness = 1 / (c_ * c_);
  ++dynamics_.counters.tangent_evaluations;
  const Instant at{t, v_of(y, dq_.size()).data()};
  dynamics_.general_system(q_, 1, stiffness, at, 1 / c_, free_system_);
  return dynamics_.factor(q_, 1, stiffness, at, 1 / c_) ? 1 : 0;
}

void IdaLinearSystem::solve(N_Vector solution, N_Vector right_hand_side) {
  const Eigen::Index n = dq_.size(), m = constraints_.count();
  const auto b1 = q_of(right_hand_side, n), b2 = v_of(right_hand_side, n);
  const auto b3 = part(right_hand_side, 2 * n, m);

  // What the held coordinates move by, and what their rates exceed c dq by.
  auto held = constraints_.apply(b1);
  auto dmu = held;
  if (stabilised_) {
    dmu = c_ * part(right_hand_side, 2 * n + m, m) - b3 - held;
    held = part(right_hand_side, 2 * n + m, m);
  } else {
    held = (held + b3) / c_;
    dmu.setZero();
  }
  rates_ = b1;
  constraints_.add_transposed(dmu, rates_);
  dynamics_.cable().mass().multiply(rates_, r_);
  r_ = b2 / (c_ * c_) + r_ / c_;
  dynamics_.add_rate_product(t_, q_, rates_, 1 / (c_ * c_), r_);

  dq_.setZero();
  constraints_.add_transposed(held, dq_);
  free_system_.multiply(dq_, product_);
  z_ = r_ - product_;
  dynamics_.cable().supports().apply(z_);
  dynamics_.solve(z_);
  dq_ += z_;
  free_system_.multiply(dq_, product_);
  product_ -= r_;

  // Last, as `solution` may be the memory of the right-hand side.
  q_of(solution, n) = dq_;
  v_of(solution, n) = c_ * dq_ - rates_;
  part(solution, 2 * n, m) = c_ * c_ * constraints_.apply(product_);
  if (stabilised_) part(solution, 2 * n + m, m) = dmu;
}

}  // namespace plumb::sundials
