#include "engine/integrate/linear_stability.h"
#include "engine/integrate/methods/one_step_method.h"
#include "engine/integrate/methods/rigid_rod.h"

namespace plumb {
namespace {

/// The classical Runge-Kutta method of order 4 (Kutta 1901; Hairer, Nørsett, Wanner, Solving Ordinary
/// Differential Equations I, table II.1.2) for q' = v, v' = a(t, q, v): four force evaluations a step, stable
/// on the imaginary axis up to ωh = 2 √2.
class Rk4 : public OneStepMethod {
 public:
  Rk4(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : OneStepMethod(spec, 4, dynamics, start) {
    for (Eigen::VectorXd* x : {&a1_, &a2_, &a3_, &a4_}) x->resize(dynamics.size());
  }

 private:
  StepResult advance(double h, const State& from, State& to) override {
    // The stages of q are written out: k₂ of q is v + ½h a₁ and so on, so that only accelerations are kept.
    const double half = 0.5 * h, h2 = h * h, third = h / 3, sixth = h / 6;
    const double* v = from.v.data();
    dynamics().acceleration(Sum(from.q), a1_, {from.t, v});
    dynamics().acceleration(Sum(from.q).plus(half, from.v), a2_, {from.t + half, v, {half, a1_.data()}});
    dynamics().acceleration(Sum(from.q).plus(half, from.v).plus(0.25 * h2, a1_), a3_,
                            {from.t + half, v, {half, a2_.data()}});
    dynamics().acceleration(
        Sum(from.q).plus(h, from.v).plus(0.5 * h2, a2_), a4_, {from.t + h, v, {h, a3_.data()}},
        {Sum(from.q).plus(h, from.v).plus(h2 / 6, a1_).plus(h2 / 6, a2_).plus(h2 / 6, a3_).into(to.q),
         Sum(from.v).plus(sixth, a1_).plus(third, a2_).plus(third, a3_).into(to.v)},
        {Sum(to.v).plus(sixth, a4_).into(to.v)});
    return {};
  }

  Eigen::VectorXd a1_, a2_, a3_, a4_;
};

double rk4_amplification(const MethodSpec&, double z) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A(1, 0) = A(2, 1) = 0.5;
  A(3, 2) = 1;
  return runge_kutta_amplification(A, Eigen::Vector4d(1, 2, 2, 1) / 6, z);
}

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
  info.cost = {610, 150};
  info.amplification = rk4_amplification;
  return {info, made<Rk4>, make_rigid_rod};
}

}  // namespace plumb
