#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/integrate/fixed_steps.h"
#include "engine/integrate/methods/equilibrium_path.h"
#include "engine/integrate/methods/load_steps.h"
#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"
#include "engine/model/compression_limit.h"

namespace plumb {
namespace {

/// Largest error of an equilibrium, as a fraction of the length: with more the path could not be followed.
constexpr double loosest_tolerance = 1e-7;

/// Equilibrium under a load, all of the case together, that grows in proportion to time and is
/// whole at the end of the run; each step is one load step:
///   f_ext t/T − ∂U/∂q = 0,
/// on the path of equilibria from the start.
class Statics : public Method {
 public:
  Statics(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : steps_(spec.step.value()),
        follow_(static_cast<Follow>(static_cast<int>(spec.parameters.at("follow")))),
        loaded_(
            dynamics, start.q,
            std::min(spec.parameters.at("newton_tolerance"), loosest_tolerance) * dynamics.cable().length()),
        path_(loaded_, follow_, static_cast<int>(spec.parameters.at("newton_iterations"))),
        now_(start) {
    now_.v.setZero();
    if (!path_.points().empty()) {
      negative_ = path_.points().front().negative;
      now_.q = path_.start();
    }
  }

  const State& state() const override { return now_; }

  StepResult step(double stop) override {
    const FixedSteps::Step next = steps_.next(now_.t, stop);
    end_ = stop;
    const double reached = now_.t / stop, wanted = next.end / stop;
    EquilibriumPath::Found found;
    StepResult result = path_.beginning();
    if (result.ok()) result = path_.reach(wanted, found);
    if (!result.ok()) {
      explain(wanted, result);
      result.reason =
          fmt::format("{}equilibrium was reached at {:.6g} of the load and not at {:.6g} of it: {}",
                      follow_ == Follow::stable ? "a stable " : "", reached, wanted, result.reason);
      return result;
    }
    now_.t = next.end;
    now_.q = found.q;
    negative_ = found.negative;
    note(found);
    steps_.take();
    return {};
  }

  void interpolate(double t, State& at) const override {
    EquilibriumPath::Found found;
    interpolated_ = path_.between(t / end_, found);
    if (!interpolated_.ok()) {
      interpolated_.reason = fmt::format("no equilibrium to be shown was found at {:.6g} of the load: {}",
                                         t / end_, interpolated_.reason);
      return;
    }
    at.t = t;
    at.q = found.q;
    at.v = now_.v;
    negative_between_ = found.negative;
    note(found);
  }

  StepResult interpolated() const override { return interpolated_; }
  std::optional<int> negative_eigenvalues(double t) const override {
    return t == now_.t ? negative_ : negative_between_;
  }

  StepResult conclusion() const override {
    if (!unstable_) return {};
    return {
        Outcome::unstable_equilibrium,
        fmt::format("an equilibrium is there at {:.6g} of the load that the cable would leave at the least "
                    "disturbance: the stiffness has {}{}",
                    unstable_->share, eigenvalues_in_words(unstable_->negative), lost_at()),
        -1};
  }

  void add_to(Trajectory& trajectory) const override {
    trajectory.equilibria.path = path_.points();
    trajectory.equilibria.critical_points = path_.critical_points();
  }

 private:
  /// What the cable would leave is remembered.
  void note(const EquilibriumPath::Found& found) const {
    if (found.negative != 0 && (!unstable_ || found.share < unstable_->share)) unstable_ = found;
  }

  /// Where the path lost its stability.
  std::string lost_at() const {
    for (const CriticalPoint& point : path_.critical_points())
      if (point.negative_before == 0)
        return fmt::format("; stability was lost at {:.6g} of the load, at a {}, in the mode {}", point.load,
                           in_words(point.kind), mode_in_words(point));
    return "";
  }

  /// Says why there is no equilibrium, where that can be told.
  void explain(double fraction, StepResult& result) const {
    if (result.outcome != Outcome::no_convergence && result.outcome != Outcome::singular) return;
    const auto overloaded = overloaded_element(loaded_.cable(), now_.q, fraction);
    if (!overloaded) return;
    result.outcome = Outcome::no_convergence;
    result.element = overloaded->element;
    const auto& points = path_.critical_points();
    const std::string limit =
        !points.empty() && points.back().kind == CriticalKind::limit_point
            ? fmt::format("a limit point is at {:.6g} of the load: ", points.back().load)
            : "";
    result.reason =
        limit +
        fmt::format(
            "the Green-Lagrange bar bears at most {:.5f} EA in compression, at a stretch of 1/√3, and this "
            "element would have to bear {:.5g} EA",
            green_compression_limit, overloaded->compression);
  }

  FixedSteps steps_;
  Follow follow_;
  mutable LoadedCable loaded_;
  mutable EquilibriumPath path_;
  State now_;
  double end_ = 0;  // of the run, s
  mutable StepResult interpolated_;
  std::optional<int> negative_;
  mutable std::optional<int> negative_between_;
  mutable std::optional<EquilibriumPath::Found> unstable_;  // under the least load
};

}  // namespace

MethodEntry statics_entry() {
  MethodInfo info;
  info.name = "statics";
  info.summary =
      "equilibrium under a load that grows with time and is whole at the end; a step is a load step";
  info.source = "arc length: Riks 1979, Crisfield 1981; damped motion: Kelley and Keyes 1998";
  info.order = "–";
  info.conserves = "nothing";
  info.use = "where a cable comes to rest, and up to which load there is such a place";
  info.family = MethodFamily::quasi_static;
  info.implicit = true;
  info.dynamic = false;
  info.takes_step = true;
  info.cost = {6000, 20000};
  info.parameters = newton_parameters();
  info.parameters.front().meaning =
      "largest error left of a position, or of a slope times the element length, as a fraction of the "
      "cable's "
      "length";
  info.parameters.front().fallback = 1e-10;
  MethodParameter follow;
  follow.name = "follow";
  follow.meaning =
      "where the path of equilibria goes on beyond a limit point or a bifurcation: where the cable "
      "would go, or along the same path, stable or not";
  follow.words = {"stable", "primary"};
  follow.maximum = 1;
  follow.whole = true;
  info.parameters.push_back(follow);
  return {info, [](const MethodSpec& spec, Dynamics& dynamics, const State& start) {
            const Cable& cable = dynamics.cable();
            return cable.variable_loads().empty() && cable.motion().none()
                       ? made<Statics>(spec, dynamics, start)
                       : make_load_steps(spec, dynamics, start);
          }};
}

}  // namespace plumb
