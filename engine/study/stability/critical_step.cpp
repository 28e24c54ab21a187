#include "engine/study/stability/critical_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/integrate/linear_stability.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/cable.h"
#include "engine/model/greatest_eigenfrequency.h"
#include "engine/study/reference/classify_outcome.h"

namespace plumb {
namespace {

/// ω of the fastest vibration at the start of a case and the greatest along its motion, rad/s.
struct Frequencies {
  double at_start, at_worst;
};

Frequencies frequencies(Case spec, double time_limit) {
  // Enough to meet the vibrations of a stretched cable, which are slower than those that limit a step.
  constexpr double states = 1000, tolerance = 1e-8;
  const Cable cable(spec);
  const double at_start = fastest_vibration(cable, cable.start_q(spec.start)).frequency;
  spec.method = plain_method(accurate_explicit(spec));
  spec.method.rtol = spec.method.atol = tolerance;
  spec.time.output_interval = std::min(spec.time.output_interval, spec.time.end / states);
  Frequencies result{at_start, at_start};
  for (const Eigen::VectorXd& q : integrate(spec, {}, time_limit).q)
    result.at_worst = std::max(result.at_worst, fastest_vibration(cable, q).frequency);
  return result;
}

class StepSearch {
 public:
  StepSearch(const Case& spec, CriticalStep& found, double time_limit)
      : spec_(spec), found_(found), time_limit_(time_limit) {}

  /// Encloses the limit, going up or down from a step (s), and then bisects.
  void from(double step) {
    constexpr double stride = 1.25;
    // A run of so few steps shows no limit, one of so many is not worth its time.
    const double largest = spec_.time.end / 8, smallest = spec_.time.end / 1e8;
    step = std::clamp(step, smallest, largest);
    while (!out_of_time_ && found_.stable < 0 && step >= smallest) {
      try_step(step);
      step /= stride;
    }
    while (!out_of_time_ && found_.stable > 0 && found_.unstable < 0 && stride * found_.stable <= largest)
      try_step(stride * found_.stable);
    while (!out_of_time_ && found_.stable > 0 && found_.unstable > (1 + critical_step_share) * found_.stable)
      try_step(std::sqrt(found_.stable * found_.unstable));
  }

 private:
  void try_step(double step) {
    spec_.method = found_.method;
    spec_.method.step = step;
    const Trajectory run = integrate(spec_, {}, time_limit_);
    out_of_time_ = run.outcome == Outcome::out_of_time;
    if (out_of_time_) return;
    Outcome outcome = run.outcome;
    if (outcome == Outcome::completed && found_.limit_kind == LimitKind::vibration)
      for (const Energies& energies : run.energies)
        if (!(energies.total() - run.energies.front().total() <= energy_share * run.kinetic_scale()))
          outcome = Outcome::unstable;
    if (outcome == Outcome::completed) {
      found_.stable = step;
    } else {
      found_.unstable = step;
      found_.beyond = outcome;
    }
  }

  Case spec_;
  CriticalStep& found_;
  double time_limit_;
  bool out_of_time_ = false;
};

}  // namespace

CriticalStep critical_step(const Case& spec, const MethodSpec& method, double time_limit) {
  const auto limit = stability_limit(method);
  if (!limit) throw std::invalid_argument(method.name + " takes no step");
  CriticalStep found;
  found.label = method.name;
  found.method = method;
  found.elements = spec.cable.elements;
  const Frequencies fastest = frequencies(spec, time_limit);
  if (*limit == 0) {
    found.limit_kind = LimitKind::always;
  } else {
    found.limit_kind = std::isfinite(*limit) ? LimitKind::vibration : LimitKind::contraction;
    if (std::isfinite(*limit)) found.predicted = {*limit / fastest.at_start, *limit / fastest.at_worst};
  }
  // Implicit methods go far beyond what an explicit one could.
  constexpr double below = 0.95, implicit_reach = 30;
  StepSearch search(spec, found, time_limit);
  search.from(found.limit_kind == LimitKind::vibration ? below * found.predicted.at_worst
                                                       : implicit_reach / fastest.at_worst);
  return found;
}

}  // namespace plumb
