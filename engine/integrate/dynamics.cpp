#include "engine/integrate/dynamics.h"

#include <utility>

namespace plumb {

Dynamics::Dynamics(const Cable& cable)
    : counters{.steps = 0,
               .rejected_steps = 0,
               .force_evaluations = 0,
               .tangent_evaluations = 0,
               .factorizations = 0,
               .newton_iterations = 0},
      cable_(cable),
      tangent_(cable.nodes()),
      system_(cable.nodes()),
      factors_(cable.nodes()) {}

void Dynamics::force(const Eigen::VectorXd& q, Eigen::VectorXd& f) {
  ++counters.force_evaluations;
  if (const auto element = cable_.force(q, f); element && !collapsed_) collapsed_ = element;
  cable_.supports().apply(f);
}

void Dynamics::acceleration(const Eigen::VectorXd& q, Eigen::VectorXd& a) {
  force(q, a);
  cable_.mass().solve(a);
}

std::optional<int> Dynamics::factor(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor) {
  ++counters.tangent_evaluations;
  cable_.tangent(q, tangent_);
  return refactor(mass_factor, stiffness_factor);
}

std::optional<int> Dynamics::refactor(double mass_factor, double stiffness_factor) {
  ++counters.factorizations;
  system_ = tangent_;
  system_.scale(stiffness_factor);
  cable_.mass().add_to(system_, mass_factor);
  cable_.supports().apply(system_);
  return factors_.factor(system_);
}

std::optional<int> Dynamics::take_collapsed() {
  return std::exchange(collapsed_, std::nullopt);
}

}  // namespace plumb
