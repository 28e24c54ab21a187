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

std::array<double, 3> StructuralMethod::weights(Guess guess, double over) const {
  const auto [gap, older_gap] = gaps_;
  switch (guess) {
    case coasting:
      return {-scheme_.position_old / scheme_.position_new, 0, 0};
    case constant:
      return {1, 0, 0};
    case linear:
      return {1 + over / gap, -over / gap, 0};
    case quadratic: {
      // Of Newton's form, by divided differences.
      const double twice = over * (over + gap) / (gap + older_gap);
      return {1 + over / gap + twice / gap, -over / gap - twice / gap - twice / older_gap, twice / older_gap};
    }
  }
  return {};
}

StepResult StructuralMethod::solve(Guess guess, double h, StageTerms& stage, const Instant& at) {
  const auto [last, past, older] = weights(guess, between(h));
  if (guess == quadratic) guess_ = last * a_ + past * past_a_[0] + older * past_a_[1];
  if (guess == linear) guess_ = last * a_ + past * past_a_[0];
  const bool made = guess == linear || guess == quadratic;
  // What is held stays so, whatever round-off is extrapolated to.
  if (made) dynamics().cable().supports().apply(guess_);
  stage.from = {made ? 1 : last, made ? guess_.data() : a_.data()};
  return stage_.solve(stage, at, h * h * scheme_.position_new, next_a_, allowed_leftover(h));
}

StructuralMethod::Guess StructuralMethod::nearest_guess(double h) const {
  constexpr double clearly = 0.25;
  Guess nearest = next_plain_;
  double least = clearly * (next_a_ - weights(nearest, between(h))[0] * a_).squaredNorm();
  for (const Guess guess : {linear, quadratic}) {
    if (!(gaps_[guess == linear ? 0 : 1] > 0)) break;
    const auto [last, past, older] = weights(guess, between(h));
    const double distance =
        guess == linear ? (next_a_ - last * a_ - past * past_a_[0]).squaredNorm()
                        : (next_a_ - last * a_ - past * past_a_[0] - older * past_a_[1]).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = guess;
  }
  return nearest;
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
  // What took many corrections is not guessed again.
  constexpr long many = 6;
  const Guess other = plain_ == coasting ? constant : coasting;
  const long before = dynamics().counters.newton_iterations;
  const auto took_many = [&] { return dynamics().counters.newton_iterations - before > many; };
  next_plain_ = plain_;
  StepResult result = solve(first_guess_, h, stage, at);
  // To look which one is nearest costs as much as a twentieth of a correction, and the answer hardly changes.
  constexpr int between_looks = 4;
  const bool looks = !result.ok() || ++steps_since_look_ >= between_looks;
  if (!result.ok() && first_guess_ != plain_) result = solve(plain_, h, stage, at);
  if (!result.ok()) {
    if (!solve(other, h, stage, at).ok()) return result;
    next_plain_ = other;
  } else if (took_many()) {
    next_plain_ = other;
  }
  // Where accelerations are rough, extrapolation is near by chance alone.
  next_guess_ = took_many() ? next_plain_ : looks ? nearest_guess(h) : first_guess_;
  if (looks) steps_since_look_ = 0;
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
  e = (scheme_.error * h * h * h / between(h)) * (next_a_ - a_);
}

void StructuralMethod::accept() {
  first_guess_ = next_guess_;
  plain_ = next_plain_;
  gaps_ = {between(h_), gaps_[0]};
  std::swap(past_a_[0], past_a_[1]);
  std::swap(past_a_[0], a_);
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
