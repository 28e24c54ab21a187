#include "engine/integrate/methods/structural_method.h"

#include <array>
#include <utility>

#include "engine/base/dense.h"
#include "engine/model/cable.h"

namespace plumb {

StructuralMethod::StructuralMethod(const StructuralScheme& scheme, const MethodSpec& spec, Dynamics& dynamics,
                                   const State& start)
    : OneStepMethod(spec, scheme.order, dynamics, start), scheme_(scheme), stage_(spec, dynamics) {
  // A start from anything but the true acceleration costs an order.
  dynamics.acceleration(start, a_);
  if (scheme_.force_old != 0) dynamics.force(start.q, old_force_, {start.t, start.v.data()});
  // What is wrong with the start itself is found by the first step.
  dynamics.take_collapsed();
}

StepResult StructuralMethod::advance(double h, const State& from, State& to) {
  const StructuralScheme& s = scheme_;
  h_ = h;
  const double h2 = h * h;
  Sum base(from.q);
  base.plus(s.point * h, from.v);
  if (s.position_old != 0) base.plus(s.point * h2 * s.position_old, a_);
  StageTerms stage{.base = base, .reach = s.point * h2 * s.position_new};
  stage.mass = s.mass_new;
  stage.force = s.force_new;
  if (s.mass_old != 0) stage.before = {s.mass_old / s.mass_new, a_.data()};
  if (s.force_old != 0) stage.known = {s.force_old, old_force_.data()};
  Instant at{from.t + s.point * h, from.v.data()};
  if (s.velocity_old != 0) at.plus = {s.point * h * s.velocity_old, a_.data()};
  at.reach = s.point * h * s.velocity_new;
  // Two guesses: the acceleration of the step before; and that with which q₁ is q₀ + h v₀, which is the
  // better one where accelerations change at once, such as at a start, where those beside a support grow with
  // the fineness of the mesh. What took many corrections is not guessed again.
  constexpr long many = 6;
  const auto solve = [&](bool coasting) {
    stage.from = {coasting ? -s.position_old / s.position_new : 1, a_.data()};
    return stage_.solve(stage, at, h2 * s.position_new, next_a_, allowed_leftover(h));
  };
  const long before = dynamics().counters.newton_iterations;
  next_coasting_ = coasting_;
  if (StepResult result = solve(coasting_); !result.ok()) {
    if (!solve(!coasting_).ok()) return result;
    next_coasting_ = !coasting_;
  } else if (dynamics().counters.newton_iterations - before > many) {
    next_coasting_ = !coasting_;
  }
  Sum q(from.q), v(from.v);
  q.plus(h, from.v).plus(h2 * s.position_new, next_a_).into(to.q);
  v.plus(h * s.velocity_new, next_a_).into(to.v);
  if (s.position_old != 0) q.plus(h2 * s.position_old, a_);
  if (s.velocity_old != 0) v.plus(h * s.velocity_old, a_);
  const std::array both{q, v};
  best_kernels().add_up(dynamics().cable().nodes(), {both.data(), both.size()});
  if (s.force_old != 0) dynamics().force(to.q, force_, {from.t + h, to.v.data()});
  return {};
}

void StructuralMethod::estimate_error(double h, const State&, const State&, Eigen::VectorXd& e) {
  if (scheme_.order == 1) {
    e = (scheme_.error * h * h) * next_a_;
    return;
  }
  // x and a₀ lie this far apart.
  const double between = scheme_.time * h + (1 - scheme_.time) * last_h_;
  e = (scheme_.error * h * h * h / between) * (next_a_ - a_);
}

void StructuralMethod::accept() {
  coasting_ = next_coasting_;
  std::swap(a_, next_a_);
  std::swap(old_force_, force_);
  last_h_ = h_;
}

double structural_amplification(const StructuralScheme& s, double z) {
  Eigen::Matrix3d map;  // of (z q, v, a/z), with h = 1 and ω = z
  for (int column = 0; column < 3; ++column) {
    const double q = column == 0 ? 1 / z : 0, v = column == 1 ? 1 : 0, a = column == 2 ? z : 0;
    const double known = q + v + s.position_old * a;
    const double point = s.point * known + (1 - s.point) * q;
    const double x = -(s.mass_old * a + z * z * (s.force_new * point + s.force_old * q)) /
                     (s.mass_new + z * z * s.force_new * s.point * s.position_new);
    map.col(column) << z * (known + s.position_new * x), v + s.velocity_old * a + s.velocity_new * x, x / z;
  }
  return spectral_radius(map);
}

NewtonMatrix structural_matrix(const StructuralScheme& s) {
  return {s.mass_new, s.force_new * s.point * s.position_new, s.point};
}

}  // namespace plumb
