#include <algorithm>
#include <array>
#include <complex>
#include <span>
#include <vector>

#include "engine/base/dense.h"
#include "engine/integrate/fixed_steps.h"
#include "engine/integrate/methods/bdf_formula.h"
#include "engine/integrate/methods/implicit_stage.h"
#include "engine/integrate/methods/newton.h"
#include "engine/integrate/state_at.h"

namespace plumb {
namespace {

/// Backward differentiation of a fixed order with a fixed step for q' = v, M v' = f(q): with b the reach of a
/// BdfFormula and q̄, v̄ what it makes of the values before,
///   q₀ = q̄ + b v₀,   v₀ = v̄ + b a,   M a = f(q̄ + b v̄ + b² a).
/// The first values are those of the Gauss method with the same step. Only the step that ends the run may be
/// shorter, with the formula for that.
class Bdf : public Method {
 public:
  Bdf(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : order_(static_cast<int>(spec.parameters.at("order"))),
        h_(spec.step.value()),
        steps_(h_),
        stage_(spec, dynamics, weight_of_leftover),
        states_(static_cast<std::size_t>(order_ + 1), start) {
    MethodSpec starter = spec;
    starter.name = "gauss";
    if (order_ > 1) starter_ = make_method(starter, dynamics, start);
    dynamics.acceleration(start, a_);
    // What is wrong with the start itself is found by the first step.
    dynamics.take_collapsed();
  }

  const State& state() const override { return states_.front(); }

  StepResult step(double stop) override {
    const FixedSteps::Step next = steps_.next(state().t, stop);
    const StepResult result = taken_ + 1 < order_ ? start_step(stop) : advance(next);
    if (!result.ok()) return result;
    std::rotate(states_.begin(), states_.end() - 1, states_.end());
    steps_.take();
    taken_ = std::min(taken_ + 1, order_);
    return result;
  }

  /// By the polynomial that the next step would be made with, where that is as good as the method.
  void interpolate(double t, State& at) const override {
    if (taken_ < order_ && starter_) return starter_->interpolate(t, at);
    constexpr int cubic_is_enough = 2;
    if (order_ <= cubic_is_enough) return hermite_in_time(states_[1], states_[0], t, at);
    at.t = t;
    at.q.setZero(state().q.size());
    at.v.setZero(state().v.size());
    for (const State& node : states_) {
      double weight = 1;
      for (const State& other : states_)
        if (&other != &node) weight *= (t - other.t) / (node.t - other.t);
      at.q += weight * node.q;
      at.v += weight * node.v;
    }
  }

 private:
  /// Leaves the new state last of all.
  StepResult start_step(double stop) {
    const StepResult result = starter_->step(stop);
    if (result.ok()) states_.back() = starter_->state();
    return result;
  }

  StepResult advance(const FixedSteps::Step& next) {
    std::array<double, BdfFormula::highest_order> before{};
    for (std::size_t j = 0; j < static_cast<std::size_t>(order_); ++j)
      before[j] = next.h + static_cast<double>(j) * h_;
    const BdfFormula formula({before.data(), static_cast<std::size_t>(order_)});
    base_.setZero(a_.size());
    rates_.setZero(a_.size());
    for (std::size_t j = 0; j < static_cast<std::size_t>(order_); ++j) {
      base_ += formula.old[j] * states_[j].q;
      rates_ += formula.old[j] * states_[j].v;
    }
    const double b = formula.reach;
    base_ += b * rates_;
    StageTerms stage{.base = Sum(base_), .reach = b * b};
    stage.from = {1, a_.data()};
    const Instant at{next.end, rates_.data(), {}, b};
    if (const StepResult result = stage_.solve(stage, at, b * b, next_a_); !result.ok()) {
      // A step that is large against the fastest motion is out of reach of the last acceleration.
      stage.from.factor = 0;
      if (!stage_.solve(stage, at, b * b, next_a_).ok()) return result;
    }
    std::swap(a_, next_a_);
    // The oldest state has served; it is as many steps back as the order, or more.
    State& to = states_.back();
    to.t = next.end;
    to.q = base_ + (b * b) * a_;
    to.v = rates_ + b * a_;
    return {};
  }

  /// Each state is weighed several times, and its rates follow from differences over h.
  static constexpr double weight_of_leftover = 10;

  int order_;
  double h_;  // s
  FixedSteps steps_;
  ImplicitStage stage_;
  std::unique_ptr<Method> starter_;  // none for order 1
  std::vector<State> states_;        // the last one first
  int taken_ = 0;                    // steps, up to the order
  Eigen::VectorXd a_, next_a_, base_, rates_;
};

/// Of the roots ζ of (1 − iz reach) ζᵏ = Σ oldⱼ ζᵏ⁻¹⁻ʲ.
double bdf_amplification(const MethodSpec& spec, double z) {
  const int order = static_cast<int>(spec.parameters.at("order"));
  constexpr std::array<double, BdfFormula::highest_order> before{1, 2, 3, 4, 5};
  const std::span<const double> steps_before = before;
  const BdfFormula formula(steps_before.first(static_cast<std::size_t>(order)));
  Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(order, order);
  for (int j = 0; j < order; ++j)
    companion(0, j) = formula.old[static_cast<std::size_t>(j)] / std::complex<double>(1, -z * formula.reach);
  for (int i = 1; i < order; ++i) companion(i, i - 1) = 1;
  return spectral_radius(companion);
}

}  // namespace

MethodEntry bdf_entry() {
  MethodInfo info;
  info.name = "bdf";
  info.summary = "backward differentiation of a fixed order with a fixed step";
  info.source = "Curtiss and Hirschfelder 1952; Gear 1971";
  info.order = "1 to 5";
  info.conserves = "momentum";
  info.use = "to see what cvode-bdf and ida do to an oscillation; orders above 2 let some of them grow";
  info.family = MethodFamily::multistep;
  info.implicit = true;
  info.takes_step = true;
  info.varied = {"order", "order {:g}", {2, 3, 4, 5}};
  info.cost = {6600, 8000};
  info.amplification = bdf_amplification;
  info.parameters = newton_parameters();
  // Less than the errors of the higher orders.
  info.parameters.front().fallback = 1e-11;
  info.parameters.insert(info.parameters.begin(),
                         {.name = "order",
                          .meaning = "order of accuracy; 2 and below are stable at every oscillation",
                          .minimum = 1,
                          .maximum = BdfFormula::highest_order,
                          .fallback = 2,
                          .whole = true});
  return {info, made<Bdf>};
}

}  // namespace plumb
