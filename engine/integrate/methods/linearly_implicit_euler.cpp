#include "engine/integrate/linear_stability.h"
#include "engine/integrate/methods/one_step_method.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

/// Euler's implicit method with one Newton step from the old state, as the published series was computed:
///   (M + h² K(qₙ)) vₙ₊₁ = M vₙ + h f(qₙ),  qₙ₊₁ = qₙ + h vₙ₊₁,  K = −∂f/∂q,
/// with h C, C = −∂f/∂v, in the matrix too where there is damping, and the loads of the new time.
/// Order 1; damps fast motion strongly (a factor 1/√(1 + ω²h²) a step) and never says that a step is too
/// large.
class LinearlyImplicitEuler : public OneStepMethod {
 public:
  LinearlyImplicitEuler(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : OneStepMethod(spec, 1, dynamics, start) {}

 private:
  StepResult advance(double h, const State& from, State& to) override {
    const Instant end{from.t + h, from.v.data()};
    if (const auto node = dynamics().factor(from.q, 1, h * h, end, h))
      return {Outcome::singular, "the matrix M + h² K is singular",
              std::min(*node, dynamics().cable().elements() - 1)};
    dynamics().cable().mass().multiply(from.v, momentum_);
    // What damping adds at the old rates is in the matrix.
    dynamics().force(from.q, to.v, {from.t + h});
    to.v = momentum_ + h * to.v;
    dynamics().cable().supports().apply(to.v);
    dynamics().solve(to.v);
    to.q = from.q + h * to.v;
    return {};
  }

  Eigen::VectorXd momentum_;
};

double linearly_implicit_euler_amplification(const MethodSpec&, double z) {
  return radius_of_step(z, [&](double& q, double& v) {
    v = (v - z * z * q) / (1 + z * z);
    q += v;
  });
}

}  // namespace

MethodEntry linearly_implicit_euler_entry() {
  MethodInfo info;
  info.name = "linearly-implicit-euler";
  info.summary = "implicit Euler with one Newton step from the old state, as in the published run";
  info.source = "Hairer and Wanner 1996, section IV.9";
  info.order = "1";
  info.conserves = "momentum";
  info.use = "to repeat the published series; damps strongly and never complains";
  info.family = MethodFamily::structural;
  info.implicit = true;
  info.takes_step = true;
  info.cost = {1000, 1000};
  info.amplification = linearly_implicit_euler_amplification;
  return {info, made<LinearlyImplicitEuler>};
}

}  // namespace plumb
