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
      scratch_(cable.size()),
      system_(cable.nodes()) {}

void Dynamics::force(const Eigen::VectorXd& q, Eigen::VectorXd& f) {
  ++counters.force_evaluations;
  if (const auto element = cable_.force(q, f); element && !collapsed_) collapsed_ = element;
  cable_.supports().apply(f);
}

void Dynamics::acceleration(const Eigen::VectorXd& q, Eigen::VectorXd& a) {
  ++counters.force_evaluations;
  if (const auto element = cable_.force(q, a); element && !collapsed_) collapsed_ = element;
  // What acts on held coordinates has no effect on the others, and none on itself.
  cable_.mass().solve(a, scratch_);
}

void Dynamics::assemble(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor) {
  ++counters.tangent_evaluations;
  cable_.system(q, mass_factor, stiffness_factor, system_);
  cable_.supports().apply(system_);
}

std::optional<int> Dynamics::factor(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor) {
  assemble(q, mass_factor, stiffness_factor);
  ++counters.factorizations;
  definite_ = best_kernels().factor(system_.nodes(), system_.data()) < 0;
  if (definite_) return std::nullopt;
  // The matrix was overwritten by what there was of its factors.
  assemble(q, mass_factor, stiffness_factor);
  ++counters.factorizations;
  return lu_.factor(GeneralBlockTridiagonal<double>(system_));
}

void Dynamics::solve(Eigen::VectorXd& x) const {
  if (definite_)
    best_kernels().solve(system_.nodes(), system_.data(), x.data());
  else
    lu_.solve(x);
}

std::optional<int> Dynamics::take_collapsed() {
  return std::exchange(collapsed_, std::nullopt);
}

}  // namespace plumb
