#include <utility>

#include "engine/integrate/linear_stability.h"
#include "engine/integrate/methods/nystrom_pair.h"
#include "engine/integrate/methods/one_step_method.h"

namespace plumb {
namespace {

/// The explicit method of a NystromPair: eight force evaluations a step.
class RungeKuttaNystrom : public OneStepMethod {
 public:
  RungeKuttaNystrom(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : OneStepMethod(spec, order_of_control, dynamics, start) {
    for (Eigen::VectorXd& k : k_) k.resize(dynamics.size());
    dynamics.acceleration(start, k_[0]);
    dynamics.take_collapsed();
    before_a_ = k_[0];
  }

  /// Steps of its own choice are too long for the interpolation, whose error is of order 6 in q.
  bool stops_at_outputs() const override { return controlled(); }

  /// Quintic Hermite interpolation from q, v and a at both ends.
  void interpolate(double t, State& at) const override {
    const State &from = before(), &to = state();
    const double h = to.t - from.t, x = (t - from.t) / h, y = 1 - x;
    const double x2 = x * x, y2 = y * y, x3 = x2 * x, y3 = y2 * y, h2 = h * h;
    at.t = t;
    at.q = (y3 * (1 + 3 * x + 6 * x2)) * from.q + (x3 * (1 + 3 * y + 6 * y2)) * to.q +
           (h * y3 * x * (1 + 3 * x)) * from.v - (h * x3 * y * (1 + 3 * y)) * to.v +
           (0.5 * h2 * y3 * x2) * before_a_ + (0.5 * h2 * x3 * y2) * k_[0];
    // The derivatives of these polynomials by x, over h.
    at.v = (30 * x2 * y2 / h) * (to.q - from.q) + (y2 * (1 + 2 * x - 15 * x2)) * from.v +
           (x2 * (1 + 2 * y - 15 * y2)) * to.v + (0.5 * h * x * y2 * (2 - 5 * x)) * before_a_ -
           (0.5 * h * x2 * y * (2 - 5 * y)) * k_[0];
  }

 private:
  using Pair = NystromPair;
  static constexpr int order_of_control = 6;
  static constexpr std::size_t last = Pair::stages - 1;

  StepResult advance(double h, const State& from, State& to) override {
    for (std::size_t i = 1; i < last; ++i)
      dynamics().acceleration(stage(i, h, from), k_[i], {from.t + Pair::c[i] * h});
    Sum velocity(from.v);
    for (std::size_t i = 0; i < last; ++i)
      if (Pair::velocity[i] != 0) velocity.plus(h * Pair::velocity[i], k_[i]);
    static_assert(Pair::velocity[last] == 0);
    dynamics().acceleration(stage(last, h, from).into(to.q), k_[last], {from.t + h}, {velocity.into(to.v)});
    return {};
  }

  /// q + cᵢ h v + h² Σ aᵢⱼ kⱼ.
  Sum stage(std::size_t i, double h, const State& from) const {
    Sum sum(from.q);
    sum.plus(Pair::c[i] * h, from.v);
    for (std::size_t j = 0; j < i; ++j)
      if (Pair::a[i][j] != 0) sum.plus(h * h * Pair::a[i][j], k_[j]);
    return sum;
  }

  void estimate_error(double h, const State&, const State&, Eigen::VectorXd& e) override {
    e.setZero(k_[0].size());
    for (std::size_t i = 0; i < Pair::stages; ++i)
      if (const double weight = Pair::b[i] - Pair::lower[i]; weight != 0) e += (h * h * weight) * k_[i];
  }

  void accept() override {
    std::swap(before_a_, k_[0]);
    std::swap(k_[0], k_[last]);
  }

  std::array<Eigen::VectorXd, Pair::stages> k_;
  Eigen::VectorXd before_a_;  // acceleration before the last step
};

double nystrom_amplification(const MethodSpec&, double z) {
  using Pair = NystromPair;
  return radius_of_step(z, [&](double& q, double& v) {
    Pair::Row k{};
    double end_q = q + v, end_v = v;
    for (std::size_t i = 0; i < Pair::stages; ++i) {
      double stage = q + Pair::c[i] * v;
      for (std::size_t j = 0; j < i; ++j) stage += Pair::a[i][j] * k[j];
      k[i] = -z * z * stage;
      end_q += Pair::b[i] * k[i];
      end_v += Pair::velocity[i] * k[i];
    }
    q = end_q;
    v = end_v;
  });
}

}  // namespace

MethodEntry runge_kutta_nystrom_entry() {
  MethodInfo info;
  info.name = "runge-kutta-nystrom";
  info.summary = "explicit Nyström pair of order 8(6) for q'' = f(q)";
  info.source = "Dormand, El-Mikkawy and Prince 1987";
  info.order = "8";
  info.conserves = "momentum";
  info.use = "soft, coarse cables to high accuracy, and references";
  info.family = MethodFamily::explicit_one_step;
  info.takes_damping = false;
  info.takes_rotation = false;
  info.takes_step = true;
  info.takes_tolerances = true;
  info.cost = {2900, 600};
  info.amplification = nystrom_amplification;
  return {info, made<RungeKuttaNystrom>};
}

}  // namespace plumb
