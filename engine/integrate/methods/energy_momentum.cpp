#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/integrate/methods/newton.h"
#include "engine/integrate/methods/structural_method.h"
#include "engine/model/cable.h"
#include "engine/model/discrete_gradient.h"

namespace plumb {
namespace {

/// The energy-momentum method of Simo and Tarnow (1992) with a discrete gradient (Gonzalez 1996) in the place
/// of the gradient at the midpoint:
///   M (vₙ₊₁ − vₙ)/h = −D(qₙ, qₙ₊₁) + f_ext,   (qₙ₊₁ − qₙ)/h = ½ (vₙ + vₙ₊₁).
/// What has no potential acts at the midpoint. The work of D is the change of strain energy, so that the
/// total energy changes by no more than what Newton's iteration leaves over, whatever the step. Supports that
/// move do so exactly, and what they carry along is accelerated by the change of their rates over the step.
class EnergyMomentum : public OneStepMethod {
 public:
  EnergyMomentum(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : OneStepMethod(spec, 2, dynamics, start),
        tolerance_(spec.parameters.at("newton_tolerance") * dynamics.cable().length()),
        iterations_(static_cast<int>(spec.parameters.at("newton_iterations"))),
        gradient_(dynamics.cable()),
        matrix_(dynamics.cable().nodes()),
        mass_(dynamics.cable().nodes()) {
    BlockTridiagonal mass(dynamics.cable().nodes());
    dynamics.cable().system(start.q, 1, 0, mass);
    mass_ = GeneralBlockTridiagonal<double>(mass);
    dynamics.acceleration(start, last_x_);
    dynamics.take_collapsed();
  }

 private:
  StepResult advance(double h, const State& from, State& to) override {
    h_ = h;
    x_ = last_x_;
    StepResult result = solve(h, from, to);
    if (result.ok() || controlled()) return result;
    // A step that is large against the fastest motion is out of reach of the last acceleration.
    x_.setZero(from.q.size());
    return solve(h, from, to);
  }

  StepResult solve(double h, const State& from, State& to) {
    const Cable& cable = dynamics().cable();
    const bool moves = !cable.motion().none();
    MovedSupports first, last, middle;
    if (moves) {
      first = cable.motion().at(from.t);
      last = cable.motion().at(from.t + h);
      middle.velocity = 0.5 * (first.velocity + last.velocity);
      middle.acceleration = (last.velocity - first.velocity) / h;
      middle.last_rate = 0.5 * (first.last_rate + last.last_rate);
      middle.last_acceleration = (last.last_rate - first.last_rate) / h;
    }
    const auto evaluate = [&]() -> StepResult {
      to.q = from.q + h * from.v + (0.5 * h * h) * x_;
      old_q_ = from.q;
      new_q_ = to.q;
      first.add_last(old_q_);
      last.add_last(new_q_);
      ++dynamics().counters.force_evaluations;
      if (const auto element = gradient_.force(old_q_, new_q_, residual_)) {
        if (!to.q.allFinite()) return {Outcome::no_convergence, "Newton's iteration left the numbers", -1};
        return {Outcome::singular, "the slope collapsed within Newton's iteration", *element};
      }
      cable.mass().multiply(x_, inertia_);
      residual_ += cable.external_force() - inertia_;
      if (!cable.conservative()) {
        middle_ = 0.5 * (old_q_ + new_q_);
        rates_ = from.v + (0.5 * h) * x_;
        middle.add_last_rate(rates_);
        cable.add_other_forces(from.t + 0.5 * h, 1, middle_, rates_, residual_, middle);
      }
      if (moves) unheld_ = residual_;
      cable.supports().apply(residual_);
      return {};
    };
    const double tolerance = std::min(tolerance_, std::max(allowed_leftover(h), round_off * cable.length()));
    CorrectionSize correction;
    StepResult state = evaluate();
    if (!state.ok()) return state;
    double size = residual_.norm();
    for (int i = 0; i < iterations_; ++i) {
      matrix_ = mass_;
      gradient_.add_tangent(old_q_, new_q_, 0.5 * h * h, matrix_);
      if (!cable.conservative()) {
        const double rate_factor = 0.5 * h;
        cable.add_other_system(from.t + 0.5 * h, 1, middle_, rates_, 0.25 * h * h, rate_factor, matrix_);
        matrix_.add(rate_factor * cable.damping().by_mass(), mass_);
      }
      cable.supports().apply(matrix_);
      ++dynamics().counters.tangent_evaluations;
      ++dynamics().counters.factorizations;
      if (const auto node = lu_.factor(matrix_))
        return {Outcome::singular, "Newton's matrix is singular", std::min(*node, cable.elements() - 1)};
      change_ = residual_;
      lu_.solve(change_);
      ++dynamics().counters.newton_iterations;
      correction = correction_size(change_, 0.5 * h * h, cable.element().length());
      if (!std::isfinite(correction.metres)) break;
      x_ += change_;
      state = evaluate();
      double next = state.ok() ? residual_.norm() : size;
      // Where the whole way makes matters worse, a part of it is taken.
      for (int halvings = 0; halvings < most_halvings && !(state.ok() && next < 2 * size); ++halvings) {
        if (correction.metres <= tolerance) break;
        change_ *= 0.5;
        x_ -= change_;
        state = evaluate();
        next = residual_.norm();
      }
      if (!state.ok()) return state;
      size = next;
      if (correction.metres <= tolerance) {
        to.v = from.v + h * x_;
        if (cable.conservative()) return {};
        const Eigen::VectorXd ground_rates = middle.ground_rates(middle_, rates_);
        // By what the way of the ground exceeds h times these.
        MovedSupports slip;
        slip.velocity = last.origin - first.origin - h * middle.velocity;
        slip.last_rate = last.last - first.last - h * middle.last_rate;
        Eigen::VectorXd excess = slip.carried_rates(middle_);
        slip.add_last_rate(excess);
        next_work_ = cable.other_work(from.t + 0.5 * h, middle_, ground_rates, h * ground_rates + excess);
        if (moves) next_work_.supplied += work_of_supports(h, middle, ground_rates, excess);
        return {};
      }
    }
    return not_converged(correction, tolerance, cable.length());
  }

  /// What the forces of the supports do over the step, J: the balance of momentum tells them.
  double work_of_supports(double h, const MovedSupports& middle, const Eigen::VectorXd& ground_rates,
                          const Eigen::VectorXd& excess) {
    const Cable& cable = dynamics().cable();
    const Eigen::VectorXd reaction = residual_ - unheld_;
    Eigen::VectorXd acceleration = middle.accelerations(middle_, rates_);
    acceleration += x_;
    cable.mass().multiply(acceleration, inertia_);
    return h * reaction.dot(ground_rates) - (unheld_ + inertia_).dot(excess);
  }

  void estimate_error(double h, const State&, const State&, Eigen::VectorXd& e) override {
    // As for the midpoint rule: ¹/₁₂ h³ times the change of the mean acceleration over the time between
    // means.
    e = (h * h * h / (6 * (h + last_h_))) * (x_ - last_x_);
  }

  void accept() override {
    std::swap(x_, last_x_);
    last_h_ = h_;
    work_ = next_work_;
  }

  std::optional<Work> work() const override { return work_; }

  static constexpr int most_halvings = 6;
  /// Smaller corrections, as a share of the cable's length, are none.
  static constexpr double round_off = 1e-16;

  double tolerance_;  // m
  int iterations_;
  DiscreteGradient gradient_;
  GeneralBlockTridiagonal<double> matrix_, mass_;
  BlockLu<double> lu_;
  double h_ = 0, last_h_ = 0;
  Eigen::VectorXd x_, last_x_;                            // mean accelerations of this step and the last
  Eigen::VectorXd residual_, unheld_, inertia_, change_;  // unheld_: the residual with what supports take
  Eigen::VectorXd old_q_, new_q_;   // of both ends of the step, in the frame of the supports
  Eigen::VectorXd middle_, rates_;  // where and at which rates loads and damping act that have no potential
  Work work_, next_work_;           // of these in the last step and in this one
};

}  // namespace

MethodEntry energy_momentum_entry() {
  // On a linear vibration the discrete gradient is the gradient at the midpoint.
  MethodInfo info = structural_info([](const MethodSpec&) { return midpoint_scheme; });
  info.name = "energy-momentum";
  info.summary = "conserving method with a discrete gradient";
  info.source = "Simo and Tarnow 1992; Gonzalez 1996";
  info.conserves = "energy, momentum, angular momentum";
  info.keeps_energy = true;
  info.takes_rotation = false;
  info.cost = {3300, 8000};
  info.use = "long runs with large steps that must neither gain nor lose energy";
  return {info, made<EnergyMomentum>};
}

}  // namespace plumb
