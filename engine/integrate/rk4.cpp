#include "engine/integrate/one_step_method.h"

namespace plumb {
namespace {

/// The classical Runge-Kutta method of order 4 (Kutta 1901; Hairer, Nørsett, Wanner, Solving Ordinary
/// Differential Equations I, table II.1.2) for q' = v, v' = a(q): four force evaluations a step, stable on
/// the imaginary axis up to ωh = 2 √2.
class Rk4 : public OneStepMethod {
 public:
  Rk4(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : OneStepMethod(spec, 4, dynamics, start) {
    for (Eigen::VectorXd* x : {&a1_, &a2_, &a3_, &a4_, &q_}) x->resize(dynamics.size());
  }

 private:
  StepResult advance(double h, const State& from, State& to) override {
    // The stages of q are written out: k₂ of q is v + ½h a₁ and so on, so that only accelerations are kept.
    dynamics().acceleration(from.q, a1_);
    q_ = from.q + 0.5 * h * from.v;
    dynamics().acceleration(q_, a2_);
    q_ += 0.25 * h * h * a1_;
    dynamics().acceleration(q_, a3_);
    q_ = from.q + h * from.v + 0.5 * h * h * a2_;
    dynamics().acceleration(q_, a4_);
    to.q = from.q + h * from.v + (h * h / 6) * (a1_ + a2_ + a3_);
    to.v = from.v + (h / 6) * (a1_ + 2 * (a2_ + a3_) + a4_);
    return {};
  }

  Eigen::VectorXd a1_, a2_, a3_, a4_, q_;
};

}  // namespace

MethodEntry rk4_entry() {
  MethodInfo info;
  info.name = "rk4";
  info.summary = "classical explicit Runge-Kutta method with a fixed step";
  info.source = "Kutta 1901";
  info.order = "4";
  info.conserves = "momentum";
  info.use = "short steps and exact counts; stable up to ωh = 2.83 of the highest frequency";
  info.family = MethodFamily::explicit_one_step;
  info.takes_step = true;
  return {info,
          [](const MethodSpec& spec, Dynamics& dynamics, const State& start) -> std::unique_ptr<Method> {
            return std::make_unique<Rk4>(spec, dynamics, start);
          }};
}

}  // namespace plumb
