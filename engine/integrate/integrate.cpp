#include "engine/integrate/integrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/base/interrupt.h"
#include "engine/integrate/advice.h"
#include "engine/integrate/monitor.h"
#include "engine/integrate/processor_time.h"
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
  WorkDone(const Cable& cable, bool dynamic) : cable_(cable), any_(dynamic && !cable.conservative()) {}

  /// Up to the end of the last step.
  const Work& total() const { return total_; }
  /// Up to t within it.
  Work at(const Method& method, double t) {
    Work work = before_;
    if (any_) work += between(method, from_, t);
    return work;
  }
  /// A step was taken, from a time on (s).
  void add_step(const Method& method, double from) {
    if (!any_) return;
    before_ = total_;
    from_ = from;
    const std::optional<Work> own = method.work();
    total_ += own ? *own : between(method, from, method.state().t);
  }

 private:
  /// By Gauss's rule, from the method's own interpolation.
  Work between(const Method& method, double from, double to) {
    constexpr int points = 3;
    Work sum;
    for (const QuadraturePoint& point : gauss_rule(points)) {
      method.interpolate(from + point.x * (to - from), state_);
      const Work power = cable_.other_work(state_.t, state_.q, state_.v, state_.v);
      const double weight = point.weight * (to - from);
      sum += {weight * power.of_loads, weight * power.dissipated};
    }
    return sum;
  }

  const Cable& cable_;
  bool any_;
  double from_ = 0;  // s
  Work before_, total_;
  State state_;
};

void record(const Cable& cable, double t, const State& state, const Work& done, Trajectory& trajectory) {
  trajectory.times.push_back(t);
  trajectory.q.push_back(state.q);
  trajectory.v.push_back(state.v);
  cable.set_output_slopes(trajectory.q.back(), trajectory.v.back());
  trajectory.energies.push_back(cable.energies(state.q, state.v));
  trajectory.energies.back().work = done.of_loads;
  trajectory.energies.back().dissipated = done.dissipated;
}

/// The multipliers at an output that was just recorded, and how far the joints have drifted by it.
void record_constraints(const Cable& cable, const Method& method, double t, Eigen::VectorXd& lambda,
                        Trajectory& trajectory) {
  method.constraint_forces(t, lambda);
  if (lambda.size() == 0) return;
  trajectory.multipliers.push_back(lambda);
  const SupportConstraints constraints(cable.supports().spec(), cable.supports().direction(), cable.nodes());
  const Eigen::VectorXd moved = trajectory.q.back() - trajectory.q.front();
  trajectory.constraint_drift = std::max(trajectory.constraint_drift, constraints.apply(moved).norm());
}

std::string describe(const StepResult& result, const MethodSpec& method, double t, long step) {
  return fmt::format("{} ended at t = {:.6g} s in step {}{}: {}", method.name, t, step,
                     result.element >= 0 ? fmt::format(", element {}", result.element + 1) : "",
                     result.reason);
}

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

Trajectory integrate(const Case& spec, const Progress& progress, double time_limit) {
  const Cable cable(spec);
  const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  return integrate(cable, start, spec.method, spec.time, progress, time_limit);
}

Trajectory integrate(const Cable& cable, const State& start, const MethodSpec& method, const TimeSpec& time,
                     const Progress& progress, double time_limit) {
  Trajectory result;
  result.elements = cable.elements();
  result.element_length = cable.element().length();

  Dynamics dynamics(cable);
  const MethodInfo* info = find_method(method.name);
  const bool dynamic = info == nullptr || info->dynamic;
  const Monitor monitor(cable, start, dynamic);
  WorkDone done(cable, dynamic);
  const std::vector<double> outputs = output_times(time);
  const double near = same_time * time.output_interval;
  State between = start;
  Eigen::VectorXd lambda;

  const double processor_started = processor_seconds();
  const auto started = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  };
  const std::unique_ptr<Method> integrator = make_method(method, dynamics, start);
  StepResult last = monitor.check(start);
  // A start that is not even finite has nothing to show.
  if (last.outcome != Outcome::diverged) {
    record(cable, start.t, start, {}, result);
    record_constraints(cable, *integrator, start.t, lambda, result);
  }
  std::size_t next = 1;
  long failed_step = 0;
  long rejected = 0;
  long evaluations_at_clock = 0;
  while (last.ok() && next < outputs.size()) {
    stop_if_interrupted();
    const double before = integrator->state().t;
    last = integrator->step(integrator->stops_at_outputs() ? outputs[next] : time.end);
    const State& now = integrator->state();
    if (!method.step) {
      if (const long tried = integrator->rejected_steps(); tried > rejected && now.t > before) {
        rejected = tried;
        const double taken = now.t - before;
        result.shortest_cut = result.shortest_cut < 0 ? taken : std::min(result.shortest_cut, taken);
      }
    }
    const bool look =
        (dynamics.counters.steps + 1) % steps_between_looks == 0 || outputs[next] <= now.t + near;
    if (last.ok()) {
      const auto collapsed = dynamics.take_collapsed();
      done.add_step(*integrator, before);
      if (look || collapsed) last = monitor.check(now, done.total());
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
        record(cable, outputs[next], now, done.total(), result);
        record_constraints(cable, *integrator, now.t, lambda, result);
      } else {
        integrator->interpolate(outputs[next], between);
        if (last = integrator->interpolated(); !last.ok()) {
          failed_step = dynamics.counters.steps;
          break;
        }
        record(cable, outputs[next], between, done.at(*integrator, outputs[next]), result);
        Energies& energies = result.energies.back();
        Energies at_step = cable.energies(now.q, now.v);
        at_step.work = done.total().of_loads;
        at_step.dissipated = done.total().dissipated;
        energies.interpolation = energies.total() - at_step.total();
        record_constraints(cable, *integrator, outputs[next], lambda, result);
        ++result.interpolated_outputs;
      }
    }
    if (progress && dynamics.counters.steps % 256 == 0) progress(now.t);
    const long work = (dynamics.counters.force_evaluations - evaluations_at_clock) * cable.elements();
    if (next < outputs.size() && (look || work > work_between_clocks)) {
      evaluations_at_clock = dynamics.counters.force_evaluations;
      // The clock is cheaper to ask, and never behind.
      if (elapsed() > time_limit && processor_seconds() - processor_started > time_limit) {
        last = {Outcome::out_of_time, fmt::format("the time allowed, {:g} s, is over", time_limit), -1};
        failed_step = dynamics.counters.steps;
      }
    }
  }
  result.solve_seconds = elapsed();
  result.outcome = last.outcome;
  if (!last.ok()) {
    result.message = describe(last, method, integrator->state().t, failed_step);
    if (const std::string help = advice(cable, start, result, method, last.outcome); !help.empty())
      result.message += "; what would help: " + help;
  }
  result.end_time = integrator->state().t;
  result.counters = dynamics.counters;
  result.counters.rejected_steps = integrator->rejected_steps();
  return result;
}

}  // namespace plumb
