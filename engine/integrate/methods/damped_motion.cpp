#include "engine/integrate/methods/damped_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/interrupt.h"
#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

constexpr int most_steps = 4000;
constexpr double most_turn = 0.2;  // of a slope in a step

class DampedMotion {
 public:
  DampedMotion(LoadedCable& loaded, double share) : loaded_(loaded), share_(share) {
    const Cable& cable = loaded.cable();
    const double L = cable.length(), l = cable.element().length(), mass = cable.constants().mass_per_length;
    // The fastest vibration along the cable: what is shorter is resolved without need.
    shortest_ = 1e-3 * mass * l * l / cable.element().axial_stiffness();
    step_ = 0.1 * mass * L * L /
            (cable.element().axial_stiffness() * (l / L) * (l / L) +
             12 * cable.element().bending_stiffness() / (L * L));
  }

  StepResult to_rest(Eigen::VectorXd& q) {
    double energy = loaded_.potential(q, share_);
    for (int steps = 0; steps < most_steps; ++steps) {
      stop_if_interrupted();
      if (is_at_rest(q)) return {};
      if (!take_step(q, energy)) {
        if (step_ < shortest_) return no_rest("its steps became too short");
        step_ *= 0.25;
        continue;
      }
      step_ *= 2;
    }
    return no_rest(fmt::format("it did not come to rest in {} steps", most_steps));
  }

 private:
  StepResult no_rest(const std::string& why) const {
    return {Outcome::no_convergence,
            fmt::format("damped motion from there found no place to rest: {}",
                        collapsed_ ? "the slope of an element collapsed" : why),
            collapsed_.value_or(-1)};
  }

  /// Whether Newton's iteration, without any inertia, ends close by at an equilibrium that holds.
  bool is_at_rest(Eigen::VectorXd& q) {
    constexpr double close = 1e-3;
    constexpr int iterations = 12;
    if (loaded_.residual(q, share_, residual_) || loaded_.factor(q)) return false;
    if (loaded_.negative_eigenvalues() != 0) return false;
    change_ = residual_;
    loaded_.solve(change_);
    if (!(loaded_.norm(change_) <= close)) return false;
    next_ = q;
    if (!loaded_.settle(next_, share_, iterations).ok() || loaded_.negative_eigenvalues() != 0) return false;
    if (loaded_.norm(next_ - q) > 2 * close) return false;
    q = next_;
    return true;
  }

  /// One step of backward Euler's method; false where it has to be shorter.
  bool take_step(Eigen::VectorXd& q, double& energy) {
    constexpr int iterations = 10;
    constexpr double converged = 1e-7, round_off = 1e-12;
    const Cable& cable = loaded_.cable();
    const double l = cable.element().length();
    next_ = q;
    double last = 0;
    for (int i = 0; i < iterations; ++i) {
      if (const auto element = loaded_.residual(next_, share_, residual_)) {
        collapsed_ = element;
        return false;
      }
      cable.mass().multiply(next_ - q, inertia_);
      change_ = residual_ - inertia_ / step_;
      cable.supports().apply(change_);
      if (loaded_.dynamics().factor(next_, 1 / step_, 1) || loaded_.dynamics().negative_eigenvalues() != 0)
        return false;
      loaded_.dynamics().solve(change_);
      ++loaded_.dynamics().counters.newton_iterations;
      const double size = correction_size(change_, 1, l).metres / cable.length();
      if (!(size < (i > 2 ? last : 1))) return false;
      last = size;
      next_ += change_;
      if (greatest_turn(next_ - q, l) > most_turn || LoadedCable::is_reversed(q, next_)) return false;
      if (size > converged) continue;
      const double after = loaded_.potential(next_, share_);
      if (!(after <= energy + round_off * std::abs(energy))) return false;
      energy = after;
      q = next_;
      collapsed_.reset();
      return true;
    }
    return false;
  }

  LoadedCable& loaded_;
  double share_;
  double step_, shortest_;  // in τ, s²
  std::optional<int> collapsed_;
  Eigen::VectorXd residual_, change_, next_, inertia_;
};

}  // namespace

StepResult come_to_rest(LoadedCable& loaded, Eigen::VectorXd& q, double share) {
  return DampedMotion(loaded, share).to_rest(q);
}

}  // namespace plumb
