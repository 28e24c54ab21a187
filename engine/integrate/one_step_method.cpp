#include "engine/integrate/one_step_method.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/integrate/state_at.h"

namespace plumb {
namespace {

/// A sliver of a step left by round-off is not taken: the step before it reaches the stop.
constexpr double sliver = 1e-9;

}  // namespace

OneStepMethod::OneStepMethod(const MethodSpec& spec, int order, Dynamics& dynamics, const State& start)
    : h_(spec.step.value_or(0)), dynamics_(dynamics), before_(start), now_(start) {
  if (!spec.step) control_.emplace(spec.rtol.value(), spec.atol.value(), dynamics.cable().length(), order);
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
  double next = h_ * static_cast<double>(taken_ + 1);
  // Always the same h but for the step that is cut: differences of times differ in their last bits, and
  // methods keep what they have factored for h.
  double h = h_;
  if (next > stop - sliver * h_) {
    if (std::abs(next - stop) > sliver * h_) h = stop - now_.t;
    next = stop;
  }
  StepResult result = advance(h, now_, before_);
  if (!result.ok()) return result;
  keep(next);
  ++taken_;
  return result;
}

StepResult OneStepMethod::controlled_step(double stop) {
  constexpr double shortest_share = 1e-13;  // of the time to stop at; below it, time would stand still
  if (h_ == 0) {
    dynamics_.acceleration(now_.q, error_);
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
      size = control_->size(error_);
      const double wished = control_->next(h, size);
      if (size <= 1) {
        // A step cut short by the stop says nothing about the next.
        if (h < h_) {
          h_ = std::max(h_, wished);
        } else {
          control_->accept(size);
          h_ = wished;
        }
        keep(ends ? stop : now_.t + h);
        ++taken_;
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
      return {Outcome::no_convergence,
              fmt::format("the error is {:.3g} times what is allowed even with a step of {:.3g} s", size, h),
              -1};
    }
  }
}

void OneStepMethod::interpolate(double t, State& at) const {
  hermite_in_time(before_, now_, t, at);
}

}  // namespace plumb
