#include "engine/integrate/integrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/base/interrupt.h"
#include "engine/integrate/advice.h"
#include "engine/integrate/cost_forecast.h"
#include "engine/integrate/monitor.h"
#include "engine/integrate/processor_time.h"
#include "engine/integrate/symmetric_motion.h"
#include "engine/model/cable.h"
#include "engine/model/quadrature.h"
#include "engine/model/support_constraints.h"

namespace plumb {
namespace {

/// Outputs this close to a step, as a fraction of the output interval, are the state of that step.
constexpr double same_time = 1e-9;

/// Steps between two looks at the energy and the clock. A look costs about as much as the shortest step, one
/// force evaluation: with this many steps between, less than 2 % of a run (`make bench`, look). Outputs are
/// always looked at. Within the steps between, the forces tell a slope that collapses and a state that is not
/// finite.
constexpr long steps_between_looks = 64;

/// Elements whose forces were evaluated between two looks at the clock, some milliseconds' worth: where steps
/// are long, as on fine meshes, sixteen of them would go far beyond the time allowed.
constexpr long work_between_clocks = 20000;

/// Follows what has no potential does, as far as there is any.
class WorkDone {
 public:
  WorkDone(const Cable& cable, const State& start, bool dynamic)
      : cable_(cable), any_(dynamic && !cable.conservative()), carried_(carried(start)) {}

  /// Up to the end of the last step.
  const Work& total() const { return total_; }
  /// Up to t within it.
  Work at(const Method& method, double t) {
    Work work = before_;
    if (!any_) return work;
    work += between(method, from_, t);
    method.interpolate(t, state_);
    work.supplied += carried(state_) - carried_before_;
    return work;
  }
  /// A step was taken, from a time on (s).
  void add_step(const Method& method, double from) {
    if (!any_) return;
    before_ = total_;
    from_ = from;
    carried_before_ = carried_;
    carried_ = carried(method.state());
    if (const std::optional<Work> own = method.work()) {
      total_ += *own;
    } else {
      total_ += between(method, from, method.state().t);
      total_.supplied += carried_ - carried_before_;
    }
  }

 private:
  /// By Gauss's rule, from the method's own interpolation.
  Work between(const Method& method, double from, double to) {
    constexpr int points = 3;
    Work sum;
    for (const QuadraturePoint& point : gauss_rule(points)) {
      method.interpolate(from + point.x * (to - from), state_);
      const Work power = cable_.power(state_.t, state_.q, state_.v);
      const double weight = point.weight * (to - from);
      sum += {weight * power.supplied, weight * power.dissipated};
    }
    return sum;
  }

  double carried(const State& state) const {
    return any_ && !cable_.motion().none() ? cable_.carried_momentum(state.t, state.q, state.v) : 0;
  }

  const Cable& cable_;
  bool any_;
  double carried_, carried_before_ = 0;  // Cable::carried_momentum at the ends of the last step, J
  double from_ = 0;                      // s
  Work before_, total_;
  State state_;
};

/// A state as seen from the ground.
class GroundView {
 public:
  /// `dynamic`: false of equilibria, which have no rates.
  GroundView(const Cable& cable, bool dynamic) : cable_(cable), dynamic_(dynamic) {}

  /// Of one that is relative to the supports. Good until the next call.
  const State& of(const State& relative) {
    if (cable_.motion().none()) return relative;
    state_ = relative;
    cable_.motion().at(relative.t).to_ground(state_.q, state_.v);
    if (!dynamic_) state_.v.setZero();
    return state_;
  }

  /// The other way.
  State relative(State ground) const {
    if (cable_.motion().none()) return ground;
    cable_.motion().at(ground.t).to_relative(ground.q, ground.v);
    cable_.supports().apply(ground.v);
    return ground;
  }

 private:
  const Cable& cable_;
  bool dynamic_;
  State state_;
};

State in_units(const State& start, const OwnUnits& units) {
  State result = start;
  result.t /= units.time;
  scale_nodal(1 / units.length, 1, result.q);
  scale_nodal(units.time / units.length, units.time, result.v);
  return result;
}

/// Vibrations that were found in these units, in m, s and kg again.
void in_si(const OwnUnits& units, Vibrations& vibrations) {
  const double root = std::sqrt(units.mass);
  vibrations.spin /= units.time;
  for (VibrationMode& mode : vibrations.modes) {
    mode.frequency /= units.time;
    mode.decay /= units.time;
    scale_nodal(1 / root, 1 / (root * units.length), mode.shape);
    scale_nodal(1 / root, 1 / (root * units.length), mode.quadrature);
  }
}

/// Writes outputs down, in m, s and kg again and as seen from the ground.
class Recorder {
 public:
  /// `start`: relative to the supports, in own units; `load_grows_to`: when the load is whole that grows in
  /// proportion to time, s; 0: it does not grow.
  Recorder(const Cable& cable, const Cable& own_cable, bool dynamic, double load_grows_to, const State& start,
           const OwnUnits& units, Trajectory& trajectory)
      : cable_(cable),
        own_cable_(own_cable),
        view_(own_cable, dynamic),
        start_(start.q),
        units_(units),
        load_grows_to_(load_grows_to),
        trajectory_(trajectory) {}

  /// `state` at the output time t (s), of the last step of `method`, in its own units, as is what has been
  /// done.
  void record(double t, const State& state, const Work& done, const Method& method) {
    record(t, state, done);
    record_extras(state, method);
  }

  /// The same of a state between the last two steps, at the later of which it is `at_step`.
  void record_between(double t, const State& state, const Work& done, const Work& at_step,
                      const Method& method) {
    record(t, state, done);
    record_extras(state, method);
    // An equilibrium is found, and not interpolated.
    if (load_grows_to_ > 0) return;
    Energies& energies = trajectory_.energies.back();
    energies.interpolation = energies.total() - energies_of(in_si(method.state()), at_step).total();
  }

 private:
  State in_si(const State& own) {
    State state = view_.of(own);
    scale_nodal(units_.length, 1, state.q);
    scale_nodal(units_.length / units_.time, 1 / units_.time, state.v);
    return state;
  }

  /// Of a state in m and s, and of work in own units.
  Energies energies_of(const State& state, const Work& done) const {
    Energies result = cable_.energies(state.q, state.v);
    result.work = done.supplied * units_.moment();
    result.dissipated = done.dissipated * units_.moment();
    return result;
  }

  void record(double t, const State& own, const Work& done) {
    State state = in_si(own);
    trajectory_.energies.push_back(energies_of(state, done));
    if (load_grows_to_ > 0) trajectory_.energies.back().potential *= t / load_grows_to_;
    cable_.set_output_slopes(state.q, state.v);
    trajectory_.times.push_back(t);
    trajectory_.q.push_back(std::move(state.q));
    trajectory_.v.push_back(std::move(state.v));
  }

  /// What a method has beside the state of an output that was just recorded: the stability of an equilibrium,
  /// the multipliers of joints and how far these have drifted.
  void record_extras(const State& state, const Method& method) {
    if (const auto negative = method.negative_eigenvalues(state.t))
      trajectory_.equilibria.negative_eigenvalues.push_back(*negative);
    method.constraint_forces(state.t, lambda_);
    if (lambda_.size() == 0) return;
    const SupportConstraints constraints(cable_.supports().spec(), cable_.supports().direction(),
                                         cable_.nodes());
    constraints.scale(units_.force(), units_.moment(), lambda_);
    if (own_cable_.motion().turns()) constraints.turn(own_cable_.motion().at(state.t).turn, lambda_);
    trajectory_.multipliers.push_back(lambda_);
    Eigen::VectorXd moved = state.q - start_;
    scale_nodal(units_.length, cable_.length(), moved);
    trajectory_.constraint_drift = std::max(trajectory_.constraint_drift, constraints.apply(moved).norm());
  }

  const Cable& cable_;
  const Cable& own_cable_;
  GroundView view_;
  Eigen::VectorXd start_;
  const OwnUnits& units_;
  double load_grows_to_;
  Trajectory& trajectory_;
  Eigen::VectorXd lambda_;
};

std::string describe(const StepResult& result, const MethodSpec& method, double t, long step) {
  const std::string element = result.element >= 0 ? fmt::format(", element {}", result.element + 1) : "";
  const MethodInfo* info = find_method(method.name);
  if (info != nullptr && info->timeless) return fmt::format("{}{}: {}", method.name, element, result.reason);
  return fmt::format("{} ended at t = {:.6g} s in step {}{}: {}", method.name, t, step, element,
                     result.reason);
}

Trajectory run(const Cable& cable, const State& start, const MethodSpec& method, const TimeSpec& time,
               const Progress& progress, const TimeLimit& limit) {
  Trajectory result;
  result.elements = cable.elements();
  result.element_length = cable.element().length();

  const OwnUnits units = OwnUnits::of(cable.length(), time.end, cable.total_mass());
  const Cable own_cable = cable.in_units(units);
  const State ground_start = in_units(start, units);
  MethodSpec own_method = method;
  if (own_method.step) *own_method.step /= units.time;
  const double end = time.end / units.time;

  const MethodInfo* info = find_method(method.name);
  const bool dynamic = info == nullptr || info->dynamic;
  GroundView view(own_cable, dynamic);
  const State own_start = view.relative(ground_start);
  const Monitor monitor(own_cable, ground_start, end, dynamic);
  WorkDone done(own_cable, own_start, dynamic);
  Dynamics dynamics(own_cable, {monitor.own_time(), end});
  const bool timeless = info != nullptr && info->timeless;
  const std::vector<double> output_seconds = timeless ? std::vector{start.t} : output_times(time);
  std::vector<double> outputs = output_seconds;
  for (double& t : outputs) t /= units.time;
  const double near = same_time * (time.output_interval / units.time);
  State between = own_start;
  const double load_grows_to = dynamic || timeless ? 0 : time.end;
  Recorder recorder(cable, own_cable, dynamic, load_grows_to, own_start, units, result);

  const double processor_started = processor_seconds();
  const auto started = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  };
  std::optional<CostForecast> forecast;
  if (!limit.looked_at.empty() && dynamic && !timeless) forecast.emplace(limit.seconds);
  const auto next_looked_at = [&](double t) {
    const auto later = std::upper_bound(limit.looked_at.begin(), limit.looked_at.end(), t * units.time);
    return later == limit.looked_at.end() ? end : *later / units.time;
  };
  const std::unique_ptr<Method> integrator = make_method(own_method, dynamics, own_start);
  StepResult last = monitor.check(ground_start);
  // A start that is not even finite has nothing to show.
  if (last.outcome != Outcome::diverged)
    // Statics begins with an equilibrium that is found from the start.
    recorder.record(start.t, dynamic ? own_start : integrator->state(), {}, *integrator);
  std::size_t next = 1;
  long failed_step = 0;
  long rejected = 0;
  long evaluations_at_clock = 0;
  while (last.ok() && next < outputs.size()) {
    stop_if_interrupted();
    const double before = integrator->state().t;
    last = integrator->step(integrator->stops_at_outputs() ? outputs[next] : end);
    const State& now = integrator->state();
    if (!method.step) {
      if (const long tried = integrator->rejected_steps(); tried > rejected && now.t > before) {
        rejected = tried;
        const double taken = (now.t - before) * units.time;
        result.shortest_cut = result.shortest_cut < 0 ? taken : std::min(result.shortest_cut, taken);
      }
    }
    const bool look =
        (dynamics.counters.steps + 1) % steps_between_looks == 0 || outputs[next] <= now.t + near;
    if (last.ok()) {
      const auto collapsed = dynamics.take_collapsed();
      done.add_step(*integrator, before);
      if (look || collapsed) last = monitor.check(view.of(now), done.total());
      if (last.ok() && collapsed)
        last = {Outcome::singular, "the slope collapsed within the step", *collapsed};
      if (last.ok()) ++dynamics.counters.steps;
    }
    if (!last.ok()) {
      failed_step = dynamics.counters.steps + 1;
      break;
    }
    for (; next < outputs.size() && outputs[next] <= now.t + near; ++next) {
      if (std::abs(outputs[next] - now.t) <= near) {
        recorder.record(output_seconds[next], now, done.total(), *integrator);
      } else {
        integrator->interpolate(outputs[next], between);
        if (last = integrator->interpolated(); !last.ok()) {
          failed_step = dynamics.counters.steps;
          break;
        }
        recorder.record_between(output_seconds[next], between, done.at(*integrator, outputs[next]),
                                done.total(), *integrator);
        ++result.interpolated_outputs;
      }
    }
    if (progress && dynamics.counters.steps % 256 == 0) progress(now.t * units.time);
    const long work = (dynamics.counters.force_evaluations - evaluations_at_clock) * cable.elements();
    if (next < outputs.size() && (look || work > work_between_clocks)) {
      evaluations_at_clock = dynamics.counters.force_evaluations;
      // The clock is cheaper to ask, and never behind.
      const double passed = elapsed();
      const bool due = forecast && passed >= forecast->due();
      const double used = due || passed > limit.seconds ? processor_seconds() - processor_started : 0;
      const double foreseen_at = due ? next_looked_at(now.t) : end;
      const auto foreseen = due ? forecast->too_long(now.t, used, foreseen_at) : std::nullopt;
      if (used > limit.seconds) {
        last = {Outcome::out_of_time, fmt::format("the time allowed, {:g} s, is over", limit.seconds), -1};
      } else if (foreseen) {
        result.foreseen_seconds = *foreseen;
        last = {
            Outcome::out_of_time,
            fmt::format("the time allowed, {:g} s, would not do: it took {:.2g} s up to {:.3g} s, from which "
                        "{:.2g} s were predicted up to {:.3g} s",
                        limit.seconds, used, now.t * units.time, *foreseen, foreseen_at * units.time),
            -1};
      }
      if (!last.ok()) failed_step = dynamics.counters.steps;
    }
  }
  result.solve_seconds = elapsed();
  result.processor_seconds = processor_seconds() - processor_started;
  if (last.ok()) {
    last = integrator->conclusion();
    failed_step = dynamics.counters.steps;
  }
  integrator->add_to(result);
  for (PathPoint& point : result.equilibria.path) point.displacement *= units.length;
  for (CriticalPoint& point : result.equilibria.critical_points) point.displacement *= units.length;
  in_si(units, result.vibrations);
  for (VibrationMode& mode : result.vibrations.modes) {
    if (mode.quadrature.size() > 0)
      cable.set_output_slopes(mode.shape, mode.quadrature);
    else
      cable.set_output_slopes(mode.shape, mode.shape);
  }
  result.outcome = last.outcome;
  result.end_time = integrator->state().t * units.time;
  if (!last.ok()) {
    result.message = describe(last, method, result.end_time, failed_step);
  }
  result.counters = dynamics.counters;
  result.counters.rejected_steps = integrator->rejected_steps();
  return result;
}

/// Runs what is to be advised after `failed`, all of it in no more than some multiple of the time that that
/// took.
class Attempts {
 public:
  Attempts(const Cable& cable, const State& start, const TimeSpec& time, const Trajectory& failed)
      : cable_(cable),
        start_(start),
        time_(time),
        failed_(failed),
        over_(processor_seconds() + std::clamp(times_as_long * failed.solve_seconds, shortest, longest)) {}

  /// An Attempt.
  std::string operator()(const MethodSpec& method) const {
    const double left = over_ - processor_seconds();
    if (left <= 0) return "";
    const Trajectory trial = run(cable_, start_, method, time_, {}, left);
    if (trial.outcome == Outcome::completed) return "to the end";
    return trial.outcome == Outcome::out_of_time && trial.end_time > beyond * failed_.end_time
               ? fmt::format("to {:.3g} s", trial.end_time)
               : "";
  }

 private:
  static constexpr double times_as_long = 20, shortest = 1, longest = 20;  // s
  static constexpr double beyond = 1.25;  // of the time at which the run failed

  const Cable& cable_;
  const State& start_;
  const TimeSpec& time_;
  const Trajectory& failed_;
  double over_;  // s of the processor
};

}  // namespace

std::vector<double> output_times(const TimeSpec& time) {
  std::vector<double> times;
  const auto whole = static_cast<long>(std::floor(time.end / time.output_interval + same_time));
  for (long k = 0; k <= whole; ++k) times.push_back(static_cast<double>(k) * time.output_interval);
  if (time.end - times.back() > same_time * time.output_interval)
    times.push_back(time.end);
  else
    times.back() = time.end;
  return times;
}

Trajectory integrate(const Case& spec, const Progress& progress, TimeLimit limit) {
  const Cable cable(spec);
  const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  return integrate(cable, start, spec.method, spec.time, progress, limit);
}

Trajectory integrate(const Cable& cable, const State& start, const MethodSpec& method, const TimeSpec& time,
                     const Progress& progress, TimeLimit limit) {
  Trajectory result = run(cable, start, method, time, progress, limit);
  const MethodInfo* info = find_method(method.name);
  if (info != nullptr && info->dynamic) result.unstable_since = unstable_since(cable, result);
  if (result.outcome == Outcome::completed) return result;
  // A run whose time is limited is one of many, and has none for others.
  const Attempt attempt =
      limit.seconds == no_time_limit ? Attempt(Attempts(cable, start, time, result)) : Attempt();
  if (const std::string help = advice(cable, start, result, method, result.outcome, attempt); !help.empty())
    result.message += "; what would help: " + help;
  return result;
}

}  // namespace plumb
