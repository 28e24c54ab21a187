#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/integrate/fixed_steps.h"
#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"
#include "engine/model/compression_limit.h"

namespace plumb {
namespace {

/// Halvings of a correction, at most.
constexpr int most_halvings = 50;
/// Change of a slope in a halved correction, at most: no slope may turn round in one.
constexpr double most_turn = 1;
/// Change of a slope in a whole correction beyond which no way leads back.
constexpr double most_overshoot = 10;
/// A correction this many lengths of the cable long is one by the round-off of a singular matrix.
constexpr double singular_correction = 1e10;

/// Equilibrium under a load, all of the case together, that grows in proportion to time and is
/// whole at the end of the run, beside what a factor of its own does; each step is one load step:
///   f_ext t/T − ∂U/∂q = 0,  by Newton's iteration  K dq = f_ext t/T − ∂U/∂q.
/// A correction is halved until the next one, with the same matrix, is the smaller (the natural monotonicity
/// test of Deuflhard 2004, section 3.3), which does not depend on the units of forces and moments.
class Statics : public Method {
 public:
  Statics(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : tolerance_(spec.parameters.at("newton_tolerance") * dynamics.cable().length()),
        iterations_(static_cast<int>(spec.parameters.at("newton_iterations"))),
        steps_(spec.step.value()),
        dynamics_(dynamics),
        before_(start),
        now_(start) {
    before_.v.setZero();
    now_.v.setZero();
  }

  const State& state() const override { return now_; }

  StepResult step(double stop) override {
    const FixedSteps::Step next = steps_.next(now_.t, stop);
    end_ = stop;
    const double reached = now_.t / stop, wanted = next.end / stop;
    StepResult result = solve(now_.q, wanted);
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
    interpolated_ = solve(now_.q, t / end_);
    if (!interpolated_.ok() && !solve(before_.q, t / end_).ok()) {
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
  /// Leaves a stable equilibrium in q_, found from the one at `from`. Whole corrections come first: they
  /// overshoot and come back where a cable that hardly stretches bends, which halved ones crawl along.
  StepResult solve(const Eigen::VectorXd& from, double fraction) const {
    StepResult whole = iterate(from, fraction, false);
    if (whole.outcome == Outcome::singular) return whole;
    if (whole.ok() && !reversed(from)) {
      whole = stability(fraction);
      if (whole.ok()) return whole;
    }
    StepResult halved = iterate(from, fraction, true);
    if (halved.ok()) halved = stability(fraction);
    if (halved.ok() || whole.outcome != Outcome::unstable_equilibrium) whole = halved;
    if (whole.outcome == Outcome::no_convergence) explain(fraction, whole);
    return whole;
  }

  /// Whether the cable would stay at the equilibrium q_.
  StepResult stability(double fraction) const {
    // Loads without a potential may make it flutter as well, which takes more than the stiffness to tell.
    if (!dynamics_.cable().has_symmetric_tangent()) return {};
    if (const auto node = dynamics_.factor(q_, 0, 1, at(fraction))) return singular(*node);
    const std::optional<int> negative = dynamics_.negative_eigenvalues();
    if (negative == 0) return {};
    return {
        Outcome::unstable_equilibrium,
        "an equilibrium is there that the cable would leave at the least disturbance: the stiffness has " +
            (negative ? fmt::format("{} negative eigenvalue{}", *negative, *negative == 1 ? "" : "s")
                      : "an eigenvalue that is not positive"),
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
      if (const auto node = dynamics_.factor(q_, 0, 1, at(fraction))) return singular(*node);
      dynamics_.solve(change_);
      ++dynamics_.counters.newton_iterations;
      correction = correction_size(change_, 1, cable.element().length());
      if (!(correction.metres <= singular_correction * cable.length())) return singular(correction.element);
      const double rate = last > 0 ? correction.metres / last : 1;
      if (correction.metres <= tolerance_ ||
          (last > 0 && rate < 1 && correction.metres * rate / (1 - rate) <= tolerance_)) {
        q_ += change_;
        return {};
      }
      last = correction.metres;
      if (!(halved ? take_part(fraction) : take_whole(fraction))) break;
    }
    return not_converged(correction, tolerance_);
  }

  /// False where that leads astray.
  bool take_whole(double fraction) const {
    if (turn(change_) > most_overshoot) return false;
    q_ += change_;
    return !residual(q_, fraction);
  }

  /// True where an element points the other way than before the load step. A pressed bar turned inside out is
  /// in equilibrium, but not with what it was.
  bool reversed(const Eigen::VectorXd& from) const {
    for (Eigen::Index at = 6; at < q_.size(); at += 6) {
      const Vec3 was = from.segment<3>(at) - from.segment<3>(at - 6);
      if (was.dot(q_.segment<3>(at) - q_.segment<3>(at - 6)) <= 0) return true;
    }
    return false;
  }

  /// Adds as much of change_ to q_ as makes the next correction smaller; false where none of it does.
  bool take_part(double fraction) const {
    const double l = dynamics_.cable().element().length();
    const double whole = correction_size(change_, 1, l).metres;
    double share = std::min(1.0, most_turn / turn(change_));
    for (int halvings = 0; halvings <= most_halvings; ++halvings, share *= 0.5) {
      trial_ = q_ + share * change_;
      if (residual(trial_, fraction)) continue;
      next_ = residual_;
      dynamics_.solve(next_);
      if (!(correction_size(next_, 1, l).metres <= (1 - 0.25 * share) * whole)) continue;
      q_ = trial_;
      return true;
    }
    return false;
  }

  /// Greatest change of a slope, or of a chord over its length, in a change of the coordinates.
  double turn(const Eigen::VectorXd& dq) const {
    const double l = dynamics_.cable().element().length();
    double greatest = 0;
    for (Eigen::Index at = 0; at < dq.size(); at += 6) {
      greatest = std::max(greatest, dq.segment<3>(at + 3).norm());
      if (at > 0) greatest = std::max(greatest, (dq.segment<3>(at) - dq.segment<3>(at - 6)).norm() / l);
    }
    return greatest;
  }

  /// The load is that share of all of it.
  Instant at(double fraction) const { return {.t = fraction * end_, .load = fraction}; }

  /// residual_ := what is missing for equilibrium at q. Returns an element whose slope collapsed.
  std::optional<int> residual(const Eigen::VectorXd& q, double fraction) const {
    dynamics_.force(q, residual_, at(fraction));
    return dynamics_.take_collapsed();
  }

  StepResult singular(int node) const {
    return {Outcome::singular,
            "the stiffness is singular: nothing but inertia would hold the cable, as across a straight and "
            "unstretched "
            "one without bending stiffness or of one that can turn about its support",
            std::min(node, dynamics_.cable().elements() - 1)};
  }

  /// Says why there is no equilibrium, where that can be told.
  void explain(double fraction, StepResult& result) const {
    const auto overloaded = overloaded_element(dynamics_.cable(), now_.q, fraction);
    if (!overloaded) return;
    result.element = overloaded->element;
    result.reason = fmt::format(
        "the Green-Lagrange bar bears at most {:.5f} EA in compression, at a stretch of 1/√3, and this "
        "element would have to bear {:.5g} EA",
        green_compression_limit, overloaded->compression);
  }

  double tolerance_;  // m
  int iterations_;
  FixedSteps steps_;
  Dynamics& dynamics_;
  State before_, now_;
  double end_ = 0;                                                // of the run, s
  mutable Eigen::VectorXd q_, trial_, residual_, change_, next_;  // scratch
  mutable StepResult interpolated_;
};

}  // namespace

MethodEntry statics_entry() {
  MethodInfo info;
  info.name = "statics";
  info.summary =
      "equilibrium under a load that grows with time and is whole at the end; a step is a load step";
  info.source = "Newton's iteration; Deuflhard 2004, section 3.3";
  info.order = "–";
  info.conserves = "nothing";
  info.use = "where a cable comes to rest, and up to which load there is such a place";
  info.family = MethodFamily::quasi_static;
  info.implicit = true;
  info.dynamic = false;
  info.takes_step = true;
  info.cost = {3000, 8000};
  info.parameters = newton_parameters();
  return {info, made<Statics>};
}

}  // namespace plumb
