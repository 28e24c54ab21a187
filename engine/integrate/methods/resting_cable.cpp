#include "engine/integrate/methods/resting_cable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/interrupt.h"
#include "engine/integrate/methods/damped_motion.h"
#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"
#include "engine/model/small_motions.h"

namespace plumb {

MethodEntry statics_entry();

namespace {

/// Largest error left of a position, as a fraction of the length.
constexpr double tolerance = 1e-13;

/// Newton's iteration for f(q) − M S² q = 0, see SmallMotions, with its tangent K + σ M.
class HeldByMass {
 public:
  HeldByMass(LoadedCable& loaded) : loaded_(loaded), cable_(loaded.cable()) {}

  /// Leaves an equilibrium in q, found from there; loads and the square of the spin grow in that many steps.
  StepResult settle(Eigen::VectorXd& q, int load_steps) {
    for (int step = 1; step <= load_steps; ++step)
      if (StepResult result = solve(q, static_cast<double>(step) / load_steps); !result.ok()) return result;
    return {};
  }

  /// Whether nothing is left to be balanced at q.
  bool is_at_rest(const Eigen::VectorXd& q) {
    constexpr double round_off = 1e-12;
    if (residual(q, 0)) return false;
    const Eigen::VectorXd without = residual_;
    if (residual(q, 1)) return false;
    const double of_loads = (residual_ - without).norm(), left = residual_.norm();
    // Loads may be as small as the round-off of a stiff and finely divided cable, and bend it yet.
    if (of_loads > round_off * loaded_.load().norm()) return left <= round_off * of_loads;
    return loaded_.has_converged(0, 0, residual_, 1, loaded_.tolerance());
  }

  /// Corrects an equilibrium as long as that leaves less: frequencies depend on tensions that may be tiny
  /// beside the stiffness.
  void sharpen(Eigen::VectorXd& q) {
    constexpr int iterations = 10;
    constexpr double less = 0.5;
    if (residual(q, 1)) return;
    for (int i = 0; i < iterations; ++i) {
      const double before = residual_.norm();
      Eigen::VectorXd next = q;
      if (!(before > 0) || correct(next, 1, least_mass * fastest())) return;
      next += change_;
      if (residual(next, 1) || !(residual_.norm() < less * before)) return;
      q = next;
    }
  }

 private:
  std::optional<int> residual(const Eigen::VectorXd& q, double share) {
    const std::optional<int> collapsed = loaded_.residual(q, share, residual_);
    const Vec3& spin = cable_.spin();
    if (spin.isZero(0)) return collapsed;
    turned_.resize(q.size());
    for (Eigen::Index at = 0; at < q.size(); at += 3)
      turned_.segment<3>(at) = spin.cross(spin.cross(q.segment<3>(at)));
    cable_.mass().multiply(turned_, change_);
    cable_.supports().apply(change_);
    residual_ -= share * change_;
    return collapsed;
  }

  /// change_ := (K + mass M)⁻¹ residual_ at q. Returns the node at which that is singular.
  std::optional<int> correct(const Eigen::VectorXd& q, double share, double mass) {
    Dynamics& dynamics = loaded_.dynamics();
    BlockLu<double> factors;
    if (const auto node = SmallMotions(cable_, q, share * dynamics.times().duration).factor(mass, factors))
      return node;
    ++dynamics.counters.tangent_evaluations;
    ++dynamics.counters.factorizations;
    ++dynamics.counters.newton_iterations;
    change_ = residual_;
    factors.solve(change_);
    return std::nullopt;
  }

  /// Of sound along the cable over its length, squared, 1/s².
  double fastest() const {
    const ElementConstants& c = cable_.constants();
    return c.axial_stiffness / (c.mass_per_length * cable_.length() * cable_.length());
  }

  StepResult solve(Eigen::VectorXd& q, double share) {
    constexpr int iterations = 60;
    constexpr double most_turn = 1, less = 0.1, first_mass = 1e-2;
    const double l = cable_.element().length(), L = cable_.length();
    CorrectionSize correction;
    double mass = first_mass * fastest(), last = 0;
    for (int i = 0; i < iterations; ++i) {
      stop_if_interrupted();
      if (const auto element = residual(q, share)) return LoadedCable::collapsed(*element);
      if (i > 0 && loaded_.has_converged(correction.metres, last, residual_, share, loaded_.tolerance()))
        return {};
      last = i > 0 ? correction.metres : 0;
      if (const auto node = correct(q, share, mass)) return loaded_.singular(*node);
      const double turn = greatest_turn(change_, l);
      if (!std::isfinite(turn)) break;
      if (turn > most_turn) change_ *= most_turn / turn;
      correction = correction_size(change_, 1, l);
      q += change_;
      mass = std::max(less * mass, least_mass * fastest());
    }
    return not_converged(correction, loaded_.tolerance(), L);
  }

  static constexpr double least_mass = 1e-12;

  LoadedCable& loaded_;
  const Cable& cable_;
  Eigen::VectorXd residual_, change_, turned_;
};

/// By statics, in steps of its own where it follows a path.
StepResult by_statics(Dynamics& dynamics, Eigen::VectorXd& q) {
  constexpr int load_steps = 20;
  const double end = dynamics.times().duration;
  const MethodEntry statics = statics_entry();
  MethodSpec spec = plain_method(statics.info);
  spec.parameters["newton_tolerance"] = tolerance;
  spec.step = dynamics.cable().variable_loads().empty() ? end : end / load_steps;
  const std::unique_ptr<Method> method =
      statics.make(spec, dynamics, {0, q, Eigen::VectorXd::Zero(q.size())});
  while (method->state().t < end)
    if (StepResult result = method->step(end); !result.ok()) return result;
  q = method->state().q;
  return {};
}

/// As find_rest says, but for what round-off can still be taken off.
Rest rough_rest(Dynamics& dynamics, LoadedCable& loaded, HeldByMass& held) {
  constexpr int load_steps = 10;
  const Cable& cable = dynamics.cable();
  Rest rest{loaded.start(), {}};
  if (held.is_at_rest(rest.q)) return rest;
  if (!cable.spin().isZero(0)) {
    rest.failure = held.settle(rest.q, load_steps);
    return rest;
  }
  rest.failure = by_statics(dynamics, rest.q);
  if (rest.failure.ok()) return rest;
  Rest other{loaded.start(), {}};
  if (!held.settle(other.q, 1).ok() || LoadedCable::is_reversed(loaded.start(), other.q)) return rest;
  const SmallMotions motions(cable, other.q, dynamics.times().duration);
  if (motions.count_below(0) == 0 || cable.variable_loads().has_tangent()) return other;
  Rest moved{other.q, {}};
  return come_to_rest(loaded, moved.q, 1).ok() ? moved : other;
}

}  // namespace

Rest find_rest(Dynamics& dynamics, const Eigen::VectorXd& start) {
  LoadedCable loaded(dynamics, start, tolerance * dynamics.cable().length());
  HeldByMass held(loaded);
  Rest rest = rough_rest(dynamics, loaded, held);
  if (rest.failure.ok()) held.sharpen(rest.q);
  return rest;
}

}  // namespace plumb
