#include "engine/integrate/dynamics.h"

#include <algorithm>
#include <utility>

#include "engine/integrate/state.h"
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
      by_kernels_(!cable.chain() && cable.mass().points().empty() && cable.conservative()),
      scratch_(cable.size()) {}

int Dynamics::size() const {
  return cable_.size();
}

void Dynamics::set_rates(const Instant& at, const Scaled& x) {
  using Numbers = Eigen::Map<const Eigen::VectorXd>;
  if (at.v == nullptr)
    rates_.setZero(size());
  else if (at.v != rates_.data())
    rates_ = Numbers(at.v, size());
  if (at.plus.numbers != nullptr) rates_ += at.plus.factor * Numbers(at.plus.numbers, size());
  if (at.reach != 0 && x.numbers != nullptr) rates_ += (at.reach * x.factor) * Numbers(x.numbers, size());
}

Dynamics::Placed Dynamics::placed(const Eigen::VectorXd& q, double t, bool still) {
  if (cable_.motion().none()) return {q, rates_};
  moved_ = cable_.motion().at(t);
  if (still) moved_ = moved_.at_rest();
  placed_q_ = q;
  placed_v_ = rates_;
  moved_.add_last(placed_q_);
  moved_.add_last_rate(placed_v_);
  return {placed_q_, placed_v_};
}

void Dynamics::add_other_forces(const Placed& there, const Instant& at, Eigen::VectorXd& f) const {
  if (at.load != 1) f += (at.load - 1) * cable_.external_force();
  if (!cable_.conservative()) cable_.add_other_forces(at.t, at.load, there.q, there.v, f, moved_);
}

void Dynamics::force(const Eigen::VectorXd& q, Eigen::VectorXd& f, const Instant& at) {
  free_force(q, f, at);
  cable_.supports().apply(f);
}

void Dynamics::free_force(const Eigen::VectorXd& q, Eigen::VectorXd& f, const Instant& at) {
  ++counters.force_evaluations;
  if (!cable_.conservative()) set_rates(at);
  const Placed there = placed(q, at.t, at.still);
  if (const auto element = cable_.force(there.q, f); element && !collapsed_) collapsed_ = element;
  add_other_forces(there, at, f);
}

void Dynamics::acceleration(const State& state, Eigen::VectorXd& a) {
  acceleration(Sum(state.q), a, {state.t, state.v.data()});
}

void Dynamics::acceleration(const Sum& q, Eigen::VectorXd& a, const Instant& at,
                            std::initializer_list<Sum> before, std::initializer_list<Sum> after) {
  ++counters.force_evaluations;
  if (!cable_.conservative()) set_rates(at);
  if (const auto element = cable_.acceleration(
          {q, {before.begin(), before.size()}, {after.begin(), after.size()}}, a, scratch_, at.t, &rates_);
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

void Dynamics::general_system(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor,
                              const Instant& at, double rate_factor, GeneralBlockTridiagonal<double>& A) {
  if (!system_) system_.emplace(cable_.nodes());
  if (!cable_.conservative()) set_rates(at);
  const Placed there = placed(q, at.t, at.still);
  cable_.system(there.q, mass_factor + rate_factor * cable_.damping().by_mass(), stiffness_factor, *system_);
  A.set(*system_);
  if (cable_.has_symmetric_tangent()) return;
  cable_.add_other_system(at.t, at.load, there.q, there.v, stiffness_factor, rate_factor, A, moved_);
}

void Dynamics::add_rate_product(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& b, double factor,
                                Eigen::VectorXd& y) {
  if (cable_.damping().none() && !cable_.motion().turns()) return;
  set_rates({});
  Eigen::VectorXd product = Eigen::VectorXd::Zero(size());
  cable_.add_rate_forces(placed(q, t, false).q, b, product, moved_);
  y -= factor * product;
}

std::optional<int> Dynamics::factor(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor,
                                    const Instant& at, double rate_factor) {
  ++counters.tangent_evaluations;
  ++counters.factorizations;
  const Kernels& kernels = best_kernels();
  // At rest the forces of damping do not change with q.
  const bool at_rest = rate_factor == 0 && at.v == nullptr && at.plus.numbers == nullptr &&
                       (at.still || !cable_.motion().turns());
  symmetric_ = cable_.has_symmetric_tangent() || (at_rest && !cable_.variable_loads().has_tangent());
  if (!symmetric_) {
    definite_ = false;
    GeneralBlockTridiagonal<double> system(cable_.nodes());
    general_system(q, mass_factor, stiffness_factor, at, rate_factor, system);
    cable_.supports().apply(system);
    return lu_.factor(system);
  }
  mass_factor += rate_factor * cable_.damping().by_mass();
  if (!cable_.motion().none()) set_rates({});
  const Eigen::VectorXd& there = placed(q, at.t, at.still).q;
  if (cable_.chain() || !cable_.mass().points().empty()) {
    assemble(there, mass_factor, stiffness_factor);
    definite_ = kernels.factor(cable_.nodes(), system_->data(), factors()) < 0;
  } else {
    definite_ = kernels.system_factors(cable_.constants(), mass_factor, stiffness_factor, cable_.elements(),
                                       cable_.supports(), there.data(), factors()) < 0;
  }
  return definite_ ? std::nullopt : factor_indefinite(there, mass_factor, stiffness_factor);
}

std::optional<int> Dynamics::factor(const Eigen::VectorXd& q, const NodeSpring& spring) {
  ++counters.tangent_evaluations;
  ++counters.factorizations;
  symmetric_ = true;
  assemble(q, 0, 1);
  system_->diagonal(spring.node).topLeftCorner<3, 3>() += spring.along * spring.along.transpose();
  definite_ = best_kernels().factor(cable_.nodes(), system_->data(), factors()) < 0;
  return definite_ ? std::nullopt : lu_.factor(GeneralBlockTridiagonal<double>(*system_));
}

std::optional<int> Dynamics::factor_indefinite(const Eigen::VectorXd& q, double mass_factor,
                                               double stiffness_factor) {
  definite_ = false;
  symmetric_ = true;
  ++counters.tangent_evaluations;
  ++counters.factorizations;
  assemble(q, mass_factor, stiffness_factor);
  return lu_.factor(GeneralBlockTridiagonal<double>(*system_));
}

std::optional<int> Dynamics::negative_eigenvalues() const {
  if (definite_) return 0;
  if (!symmetric_) return std::nullopt;
  const std::optional<int> counted = plumb::negative_eigenvalues(*system_);
  return counted == 0 ? std::nullopt : counted;
}

void Dynamics::solve(Eigen::VectorXd& x) const {
  if (definite_)
    best_kernels().solve(cable_.nodes(), factors_.data(), x.data());
  else
    lu_.solve(x);
}

StageCorrection Dynamics::correct(const StageTerms& stage, double stiffness_factor, Eigen::VectorXd& x,
                                  const Instant& at, bool turns) {
  const bool renews = stiffness_factor != 0;
  if (turns) turns_.resize(static_cast<std::size_t>(turns_size(cable_.nodes())));
  if (!by_kernels_ || !(definite_ || renews)) return correct_stepwise(stage, stiffness_factor, x, at, turns);
  x.resize(size());
  ++counters.force_evaluations;
  counters.tangent_evaluations += renews ? 1 : 0;
  counters.factorizations += renews ? 1 : 0;
  const StageCorrection result = best_kernels().correct(
      cable_.constants(), cable_.elements(), cable_.supports(), cable_.loads().on_nodes(), stage,
      stiffness_factor, factors(), turns ? turns_.data() : nullptr, x.data());
  if (renews) definite_ = result.singular < 0;
  if (result.unsound < 0 && !definite_) return correct_stepwise(stage, stiffness_factor, x, at, turns);
  if (result.unsound < 0) ++counters.newton_iterations;
  return result;
}

StageCorrection Dynamics::correct_stepwise(const StageTerms& stage, double stiffness_factor,
                                           Eigen::VectorXd& x, const Instant& at, bool turns) {
  StageCorrection result;
  const auto sum_of = [&](const Sum& sum, Eigen::VectorXd& to) {
    to.resize(size());
    Sum kept = sum;
    best_kernels().add_up(cable_.nodes(), kept.into(to));
  };
  sum_of(stage.point(), point_);
  ++counters.force_evaluations;
  if (!cable_.conservative()) set_rates(at, stage.from);
  const Placed here = placed(point_, at.t, at.still);
  if (const auto element = cable_.force(here.q, x)) {
    result.unsound = *element;
    return result;
  }
  add_other_forces(here, at, x);
  sum_of(stage.accelerations(), scratch_);
  cable_.mass().multiply(scratch_, inertia_);
  x = stage.force * x - stage.mass * inertia_;
  const auto array_of = [&](const Scaled& scaled) {
    return scaled.factor * Eigen::Map<const Eigen::VectorXd>(scaled.numbers, size());
  };
  if (stage.known.numbers != nullptr) x += array_of(stage.known);
  cable_.supports().apply(x);
  if (stiffness_factor != 0) {
    const Instant there{at.t, rates_.data(), {}, 0, at.load};
    const auto node = by_kernels_
                          ? factor_indefinite(point_, stage.mass, stiffness_factor)
                          : factor(point_, stage.mass, stiffness_factor, there, stage.force * at.reach);
    if (node) {
      result.singular = *node;
      return result;
    }
    if (turns) best_kernels().mark_slopes(cable_.nodes(), point_.data(), turns_.data());
    solve(x);
  } else {
    if (turns) best_kernels().turn_back(cable_.nodes(), point_.data(), turns_.data(), x.data());
    solve(x);
    if (turns) best_kernels().turn(cable_.nodes(), turns_.data(), x.data());
  }
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
