#include "engine/integrate/methods/one_step_method.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/integrate/state_at.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

/// Steps of a run, at most, where a method chooses them: a minute or so for a short cable.
constexpr double most_steps = 1e7;

}  // namespace

OneStepMethod::OneStepMethod(const MethodSpec& spec, int order, Dynamics& dynamics, const State& start)
    : tolerance_(spec.step ? 0 : spec.rtol.value() + spec.atol.value()),
      steps_(spec.step.value_or(0)),
      dynamics_(dynamics),
      before_(start),
      now_(start) {
  constexpr int low_order = 2;
  // Of the errors of steps: vibrations take the rest back, unless the method damps them.
  const double adds_up = order == 1 ? 1 : 0.25;
  if (spec.step) return;
  rtol_ = *spec.rtol;
  control_.emplace(*spec.rtol, *spec.atol, dynamics.cable().length(), order,
                   order <= low_order ? adds_up * dynamics.times().duration : 0);
}

double OneStepMethod::allowed_leftover(double h) const {
  constexpr double share = 0.1;
  const double steps = dynamics_.times().duration / h;
  return controlled() ? share * tolerance_ * dynamics_.cable().length() / (steps * steps)
                      : std::numeric_limits<double>::infinity();
}

void OneStepMethod::note_growth() {
  constexpr double clearly = 1.1;
  if (h_ > clearly * largest_step_) {
    largest_step_ = h_;
    steps_since_growth_ = 0;
  } else {
    ++steps_since_growth_;
  }
}

StepResult OneStepMethod::refusal() const {
  const double steps = dynamics_.times().duration / h_;
  constexpr double beginning = 0.1;  // of the run; what has come further may as well go on
  constexpr int settled = 20;  // steps in which it has not grown: from a cautious first one it does so slowly
  if (!(steps > most_steps) || steps_since_growth_ < settled ||
      now_.t > beginning * dynamics_.times().duration)
    return {};
  const double possible = rtol_ * control_->tolerance_ratio(steps / most_steps);
  return {Outcome::no_convergence,
          fmt::format(
              "rtol = {:g} would take some {:.2g} steps, more than {:g}; from about {:.2g} on it would not",
              rtol_, steps, most_steps, possible),
          -1};
}

void OneStepMethod::estimate_error(double, const State&, const State&, Eigen::VectorXd&) {
  throw std::logic_error("a method with a fixed step was asked for its error");
}

StepResult OneStepMethod::step(double stop) {
  return control_ ? controlled_step(stop) : fixed_step(stop);
}

void OneStepMethod::keep(double t) {
  accept();
  before_.t = t;
  std::swap(before_, now_);
}

StepResult OneStepMethod::fixed_step(double stop) {
  const FixedSteps::Step next = steps_.next(now_.t, stop);
  StepResult result = advance(next.h, now_, before_);
  if (!result.ok()) return result;
  keep(next.end);
  steps_.take();
  return result;
}

StepResult OneStepMethod::controlled_step(double stop) {
  constexpr double sliver = 1e-9;           // of a step, left by round-off and not taken
  constexpr double shortest_share = 1e-13;  // of the time to stop at; below it, time would stand still
  if (h_ == 0) {
    dynamics_.acceleration(now_, error_);
    h_ = control_->first_step(error_, stop);
  }
  const double left = stop - now_.t;
  while (true) {
    const bool ends = h_ > (1 - sliver) * left;
    // Two equal steps to the stop rather than a long one and a sliver.
    const double h = ends ? left : h_ > 0.5 * left ? 0.5 * left : h_;
    const StepResult result = advance(h, now_, before_);
    double size = 0;
    if (result.ok()) {
      estimate_error(h, now_, before_, error_);
      size = control_->size(error_, h);
      const double wished = control_->next(h, size);
      if (size <= 1) {
        // A step cut short by the stop says nothing about the next.
        if (h < h_) {
          h_ = std::max(h_, wished);
        } else {
          control_->accept(size);
          h_ = wished;
          note_growth();
          if (StepResult refused = refusal(); !refused.ok()) return refused;
        }
        keep(ends ? stop : now_.t + h);
        return result;
      }
      h_ = wished;
    } else {
      h_ = StepControl::after_failure(h);
    }
    ++rejected_;
    dynamics_.take_collapsed();
    if (h_ <= shortest_share * stop) {
      if (!result.ok()) return result;
      return {
          Outcome::no_convergence,
          fmt::format("the error is {:.3g} times what is allowed even with a step of {:.3g} of the time left",
                      size, h / left),
          -1};
    }
  }
}

void OneStepMethod::interpolate(double t, State& at) const {
  hermite_in_time(before_, now_, t, at);
}

}  // namespace plumb
