#include "engine/integrate/methods/load_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/integrate/fixed_steps.h"
#include "engine/integrate/methods/equilibrium_path.h"
#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

/// Halvings of a correction, at most.
constexpr int most_halvings = 50;
/// Change of a slope in a halved correction, at most: no slope may turn round in one.
constexpr double most_turn = 1;
/// Change of a slope in a whole correction beyond which no way leads back.
constexpr double overshoot = 10;
/// A correction this many lengths of the cable long is one by the round-off of a singular matrix.
constexpr double of_round_off = 1e10;

/// Turn of a slope between two equilibria that are taken for neighbours on a path, at most.
constexpr double most_turn_between = 0.5;
/// Halvings of a load step, at most: beyond, the cable has snapped to a place far away, if to any.
constexpr int most_halved_steps = 16;
/// Parts of a load step that are tried, at most.
constexpr int most_parts = 3000;

/// f(q, share t/T) − ∂U/∂q = 0 by Newton's iteration, in which all loads grow in proportion to time, beside
/// what a factor of their own does. A load step is halved until each equilibrium is near the one before it,
/// and begun where the last two point to.
/// A correction is halved until the next one, with the same matrix, is the smaller (the natural monotonicity
/// test of Deuflhard 2004, section 3.3), which does not depend on the units of forces and moments.
class LoadSteps : public Method {
 public:
  LoadSteps(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : iterations_(static_cast<int>(spec.parameters.at("newton_iterations"))),
        steps_(spec.step.value()),
        dynamics_(dynamics),
        loaded_(dynamics, start.q, spec.parameters.at("newton_tolerance") * dynamics.cable().length()),
        before_(start),
        now_(start) {
    before_.v.setZero();
    now_.v.setZero();
    // Whether there is an equilibrium without load does not matter to those with.
    if (solve(start.q, 0).ok()) now_.q = q_;
    before_.q = now_.q;
  }

  const State& state() const override { return now_; }

  StepResult step(double stop) override {
    const FixedSteps::Step next = steps_.next(now_.t, stop);
    end_ = stop;
    const double reached = now_.t / stop, wanted = next.end / stop;
    StepResult result = reach(now_.q, reached, wanted);
    if (!result.ok()) {
      result.reason = fmt::format(
          "{}equilibrium was reached at {:.6g} of the load and not at {:.6g} of it: {}",
          result.outcome == Outcome::unstable_equilibrium ? "a stable " : "", reached, wanted, result.reason);
      return result;
    }
    before_.t = next.end;
    before_.q = q_;
    std::swap(before_, now_);
    steps_.take();
    return result;
  }

  /// Finds the equilibrium at the load of that time: between two load steps a cable turns, which no mean of
  /// its coordinates does without stretching it.
  void interpolate(double t, State& at) const override {
    interpolated_ = reach(before_.q, before_.t / end_, t / end_);
    if (!interpolated_.ok()) {
      interpolated_.reason = fmt::format("no equilibrium to be shown was found at {:.6g} of the load: {}",
                                         t / end_, interpolated_.reason);
      return;
    }
    interpolated_ = {};
    at.t = t;
    at.q = q_;
    at.v = now_.v;
  }

  StepResult interpolated() const override { return interpolated_; }

 private:
  /// Leaves in q_ the equilibrium at a fraction of the load to which a path leads from that at another one.
  StepResult reach(const Eigen::VectorXd& start, double from, double to) const {
    const double shortest = std::ldexp(to - from, -most_halved_steps);
    const double l = dynamics_.cable().element().length();
    Eigen::VectorXd here = start, change = Eigen::VectorXd::Zero(start.size());
    double at = from, part = to - from, last_part = 0;
    for (int parts = 0; at != to; ++parts) {
      if (parts == most_parts)
        return {Outcome::no_convergence,
                fmt::format("{} parts of a load step lead to {:.6g} of the load only", most_parts, at), -1};
      const bool ends = part >= to - at;
      if (ends) part = to - at;
      const Eigen::VectorXd guess = last_part > 0 ? here + (part / last_part) * change : here;
      StepResult result = solve(guess, ends ? to : at + part);
      if (!result.ok() && last_part > 0) result = solve(here, ends ? to : at + part);
      const bool is_near = result.ok() && greatest_turn(q_ - here, l) <= most_turn_between;
      if (!is_near && part > shortest) {
        part *= 0.5;
        continue;
      }
      if (!result.ok()) return result;
      change = q_ - here;
      here = q_;
      last_part = is_near ? part : 0;
      at = ends ? to : at + part;
      part *= 2;
    }
    q_ = here;
    return {};
  }

  /// Leaves a stable equilibrium in q_, found from the one at `from`. Whole corrections come first: they
  /// overshoot and come back where a cable that hardly stretches bends, which halved ones crawl along.
  StepResult solve(const Eigen::VectorXd& from, double fraction) const {
    StepResult whole = iterate(from, fraction, false);
    if (whole.outcome == Outcome::singular) return whole;
    if (whole.ok() && !LoadedCable::is_reversed(from, q_)) {
      whole = stability(fraction);
      if (whole.ok()) return whole;
    }
    StepResult halved = iterate(from, fraction, true);
    if (halved.ok()) halved = stability(fraction);
    if (halved.ok() || whole.outcome != Outcome::unstable_equilibrium) whole = halved;
    return whole;
  }

  /// Whether the cable would stay at the equilibrium q_.
  StepResult stability(double fraction) const {
    // Loads without a potential may make it flutter as well, which takes more than the stiffness to tell.
    if (dynamics_.cable().variable_loads().has_tangent()) return {};
    if (const auto node = loaded_.factor(q_, fraction)) return loaded_.singular(*node);
    const int negative = loaded_.negative_eigenvalues();
    if (negative == 0) return {};
    return {
        Outcome::unstable_equilibrium,
        "an equilibrium is there that the cable would leave at the least disturbance: the stiffness has " +
            eigenvalues_in_words(negative),
        -1};
  }

  StepResult iterate(const Eigen::VectorXd& from, double fraction, bool halved) const {
    const Cable& cable = dynamics_.cable();
    q_ = from;
    CorrectionSize correction;
    double last = 0;  // size of the correction before this one
    if (const auto collapsed = residual(q_, fraction))
      return {Outcome::singular, "the slope collapsed within Newton's iteration", *collapsed};
    for (int i = 0; i < iterations_; ++i) {
      change_ = residual_;
      if (const auto node = loaded_.factor(q_, fraction)) return loaded_.singular(*node);
      loaded_.solve(change_);
      ++dynamics_.counters.newton_iterations;
      correction = correction_size(change_, 1, cable.element().length());
      if (!(correction.metres <= of_round_off * cable.length())) return loaded_.singular(correction.element);
      const double rate = last > 0 ? correction.metres / last : 1;
      if (correction.metres <= loaded_.tolerance() ||
          (last > 0 && rate < 1 && correction.metres * rate / (1 - rate) <= loaded_.tolerance())) {
        q_ += change_;
        return {};
      }
      last = correction.metres;
      if (!(halved ? take_part(fraction) : take_whole(fraction))) break;
    }
    return not_converged(correction, loaded_.tolerance(), cable.length());
  }

  /// False where that leads astray.
  bool take_whole(double fraction) const {
    if (turn() > overshoot) return false;
    q_ += change_;
    return !residual(q_, fraction);
  }

  /// Adds as much of change_ to q_ as makes the next correction smaller; false where none of it does.
  bool take_part(double fraction) const {
    const double l = dynamics_.cable().element().length();
    const double whole = correction_size(change_, 1, l).metres;
    double share = std::min(1.0, most_turn / turn());
    for (int halvings = 0; halvings <= most_halvings; ++halvings, share *= 0.5) {
      trial_ = q_ + share * change_;
      if (residual(trial_, fraction)) continue;
      next_ = residual_;
      loaded_.solve(next_);
      if (!(correction_size(next_, 1, l).metres <= (1 - 0.25 * share) * whole)) continue;
      q_ = trial_;
      return true;
    }
    return false;
  }

  double turn() const { return greatest_turn(change_, dynamics_.cable().element().length()); }

  /// residual_ := what is missing for equilibrium at q. Returns an element whose slope collapsed.
  std::optional<int> residual(const Eigen::VectorXd& q, double fraction) const {
    return loaded_.residual(q, fraction, residual_);
  }

  int iterations_;
  FixedSteps steps_;
  Dynamics& dynamics_;
  mutable LoadedCable loaded_;
  State before_, now_;
  double end_ = 0;                                                // of the run, s
  mutable Eigen::VectorXd q_, trial_, residual_, change_, next_;  // scratch
  mutable StepResult interpolated_;
};

}  // namespace

std::unique_ptr<Method> make_load_steps(const MethodSpec& spec, Dynamics& dynamics, const State& start) {
  return std::make_unique<LoadSteps>(spec, dynamics, start);
}

}  // namespace plumb
