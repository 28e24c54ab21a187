#include "engine/integrate/dynamics.h"

#include <algorithm>
#include <utility>

#include "engine/model/cable.h"
#include "engine/model/inertia.h"

namespace plumb {

Dynamics::Dynamics(const Cable& cable, const RunTimes& times)
    : counters{.steps = 0,
               .rejected_steps = 0,
               .force_evaluations = 0,
               .tangent_evaluations = 0,
               .factorizations = 0,
               .newton_iterations = 0},
      cable_(cable),
      times_(times),
      scratch_(cable.size()) {}

int Dynamics::size() const {
  return cable_.size();
}

void Dynamics::force(const Eigen::VectorXd& q, Eigen::VectorXd& f) {
  ++counters.force_evaluations;
  if (const auto element = cable_.force(q, f); element && !collapsed_) collapsed_ = element;
  cable_.supports().apply(f);
}

void Dynamics::acceleration(const Sum& q, Eigen::VectorXd& a, std::initializer_list<Sum> before,
                            std::initializer_list<Sum> after) {
  ++counters.force_evaluations;
  if (const auto element = cable_.acceleration(
          {q, {before.begin(), before.size()}, {after.begin(), after.size()}}, a, scratch_);
      element && !collapsed_)
    collapsed_ = element;
}

void Dynamics::assemble(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor) {
  if (!system_) system_.emplace(cable_.nodes());
  cable_.system(q, mass_factor, stiffness_factor, *system_);
  cable_.supports().apply(*system_);
}

double* Dynamics::factors() {
  if (factors_.data() == nullptr)
    factors_ = HugeArray(static_cast<std::size_t>(factor_size) * static_cast<std::size_t>(cable_.nodes()));
  return factors_.data();
}

std::optional<int> Dynamics::factor(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor) {
  ++counters.tangent_evaluations;
  ++counters.factorizations;
  const Kernels& kernels = best_kernels();
  if (cable_.chain()) {
    assemble(q, mass_factor, stiffness_factor);
    definite_ = kernels.factor(cable_.nodes(), system_->data(), factors()) < 0;
  } else {
    definite_ = kernels.system_factors(cable_.constants(), mass_factor, stiffness_factor, cable_.elements(),
                                       cable_.supports(), q.data(), factors()) < 0;
  }
  return definite_ ? std::nullopt : factor_indefinite(q, mass_factor, stiffness_factor);
}

std::optional<int> Dynamics::factor(const Eigen::VectorXd& q, const NodeSpring& spring) {
  ++counters.tangent_evaluations;
  ++counters.factorizations;
  assemble(q, 0, 1);
  system_->diagonal(spring.node).topLeftCorner<3, 3>() += spring.along * spring.along.transpose();
  definite_ = best_kernels().factor(cable_.nodes(), system_->data(), factors()) < 0;
  return definite_ ? std::nullopt : lu_.factor(GeneralBlockTridiagonal<double>(*system_));
}

std::optional<int> Dynamics::factor_indefinite(const Eigen::VectorXd& q, double mass_factor,
                                               double stiffness_factor) {
  definite_ = false;
  ++counters.tangent_evaluations;
  ++counters.factorizations;
  assemble(q, mass_factor, stiffness_factor);
  return lu_.factor(GeneralBlockTridiagonal<double>(*system_));
}

std::optional<int> Dynamics::negative_eigenvalues() const {
  if (definite_) return 0;
  const std::optional<int> counted = plumb::negative_eigenvalues(*system_);
  return counted == 0 ? std::nullopt : counted;
}

void Dynamics::solve(Eigen::VectorXd& x) const {
  if (definite_)
    best_kernels().solve(cable_.nodes(), factors_.data(), x.data());
  else
    lu_.solve(x);
}

StageCorrection Dynamics::correct(const StageTerms& stage, double stiffness_factor, Eigen::VectorXd& x) {
  const bool renews = stiffness_factor != 0;
  if (cable_.chain() || !(definite_ || renews)) return correct_stepwise(stage, stiffness_factor, x);
  x.resize(size());
  ++counters.force_evaluations;
  counters.tangent_evaluations += renews ? 1 : 0;
  counters.factorizations += renews ? 1 : 0;
  const StageCorrection result =
      best_kernels().correct(cable_.constants(), cable_.elements(), cable_.supports(),
                             cable_.loads().on_nodes(), stage, stiffness_factor, factors(), x.data());
  if (renews) definite_ = result.singular < 0;
  if (result.unsound < 0 && !definite_) return correct_stepwise(stage, stiffness_factor, x);
  if (result.unsound < 0) ++counters.newton_iterations;
  return result;
}

StageCorrection Dynamics::correct_stepwise(const StageTerms& stage, double stiffness_factor,
                                           Eigen::VectorXd& x) {
  StageCorrection result;
  const auto sum_of = [&](const Sum& sum, Eigen::VectorXd& to) {
    to.resize(size());
    Sum kept = sum;
    best_kernels().add_up(cable_.nodes(), kept.into(to));
  };
  sum_of(stage.point(), point_);
  ++counters.force_evaluations;
  if (const auto element = cable_.force(point_, x)) {
    result.unsound = *element;
    return result;
  }
  sum_of(stage.accelerations(), scratch_);
  cable_.mass().multiply(scratch_, inertia_);
  x = stage.force * x - stage.mass * inertia_;
  const auto array_of = [&](const Scaled& scaled) {
    return scaled.factor * Eigen::Map<const Eigen::VectorXd>(scaled.numbers, size());
  };
  if (stage.known.numbers != nullptr) x += array_of(stage.known);
  cable_.supports().apply(x);
  if (stiffness_factor != 0) {
    const auto node = cable_.chain() ? factor(point_, stage.mass, stiffness_factor)
                                     : factor_indefinite(point_, stage.mass, stiffness_factor);
    if (node) {
      result.singular = *node;
      return result;
    }
  }
  solve(x);
  ++counters.newton_iterations;
  result.finite = x.allFinite();
  for (Eigen::Index i = 0; i < x.size(); i += 6) {
    result.position = std::max(result.position, x.segment<3>(i).lpNorm<Eigen::Infinity>());
    result.slope = std::max(result.slope, x.segment<3>(i + 3).lpNorm<Eigen::Infinity>());
  }
  x += array_of(stage.from);
  return result;
}

std::optional<int> Dynamics::take_collapsed() {
  return std::exchange(collapsed_, std::nullopt);
}

}  // namespace plumb
