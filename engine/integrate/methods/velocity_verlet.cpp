#include <utility>

#include "engine/integrate/linear_stability.h"
#include "engine/integrate/methods/one_step_method.h"

namespace plumb {
namespace {

/// The velocity form of Störmer's and Verlet's method (Verlet 1967; Swope et al. 1982; Hairer, Lubich and
/// Wanner 2006, section I.1.4):
///   v½ = vₙ + ½h aₙ,  qₙ₊₁ = qₙ + h v½,  vₙ₊₁ = v½ + ½h aₙ₊₁.
/// Forces that depend on rates are those at vₙ + h aₙ, which keeps the order.
/// One force evaluation a step, symplectic, stable up to ωh = 2.
class VelocityVerlet : public OneStepMethod {
 public:
  VelocityVerlet(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : OneStepMethod(spec, 2, dynamics, start) {
    dynamics.acceleration(start, a_);
    next_a_.resize(dynamics.size());
    dynamics.take_collapsed();
  }

 private:
  StepResult advance(double h, const State& from, State& to) override {
    dynamics().acceleration(Sum(from.q).plus(h, from.v).plus(0.5 * h * h, a_).into(to.q), next_a_,
                            {from.t + h, from.v.data(), {h, a_.data()}}, {},
                            {Sum(from.v).plus(0.5 * h, a_).plus(0.5 * h, next_a_).into(to.v)});
    return {};
  }

  void accept() override { std::swap(a_, next_a_); }

  Eigen::VectorXd a_, next_a_;
};

double verlet_amplification(const MethodSpec&, double z) {
  return radius_of_step(z, [&](double& q, double& v) {
    const double middle = v - 0.5 * z * z * q;
    q += middle;
    v = middle - 0.5 * z * z * q;
  });
}

}  // namespace

MethodEntry velocity_verlet_entry() {
  MethodInfo info;
  info.name = "velocity-verlet";
  info.summary = "Störmer and Verlet's explicit method";
  info.source = "Verlet 1967; Hairer, Lubich and Wanner 2006, section I.1.4";
  info.order = "2";
  info.conserves = "momentum, angular momentum; symplectic";
  info.use = "the cheapest step of all, for long runs; stable up to ωh = 2 of the highest frequency";
  info.family = MethodFamily::explicit_one_step;
  info.takes_step = true;
  info.cost = {520, 40};
  info.amplification = verlet_amplification;
  return {info, made<VelocityVerlet>};
}

}  // namespace plumb
