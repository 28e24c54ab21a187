#include "engine/study/yardstick.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "engine/integrate/integrate.h"
#include "engine/integrate/method_roles.h"

namespace plumb {
namespace {

constexpr int repeats = 12;
constexpr double step = 1e-4, end = 2;  // s

Case piece_of_work() {
  Case spec;
  spec.cable.length = 1;
  spec.cable.area = 2.5e-5;
  spec.cable.density = 320;
  spec.cable.youngs_modulus = 1.6e6;
  spec.cable.second_moment = spec.cable.area * spec.cable.area / (4 * std::numbers::pi);
  spec.cable.elements = 32;
  spec.start.angular_velocity = {0, 4, 0};
  spec.supports.first = Support::pinned;
  spec.loads.gravity = {0, -9.81, 0};
  spec.method = plain_method(classical_explicit());
  spec.method.step = step;
  spec.time.end = spec.time.output_interval = end;
  return spec;
}

}  // namespace

Yardstick yardstick() {
  const Case spec = piece_of_work();
  Yardstick result;
  for (int k = 0; k < repeats; ++k) {
    const Trajectory run = integrate(spec);
    result.repeats.push_back(run.processor_seconds);
    result.steps = run.counters.steps;
    const Eigen::VectorXd& last = run.q.back();
    for (std::size_t j = 0; j < result.tip.size(); ++j)
      result.tip[j] = last[last.size() - 6 + static_cast<Eigen::Index>(j)];
  }
  result.seconds = *std::min_element(result.repeats.begin(), result.repeats.end());
  result.work = fmt::format("{} steps of {} on a pendulum of {} elements", result.steps, spec.method.name,
                            spec.cable.elements);
  return result;
}

}  // namespace plumb
