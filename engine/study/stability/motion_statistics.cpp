#include "engine/study/stability/motion_statistics.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/parallel.h"
#include "engine/integrate/integrate.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/cable.h"
#include "engine/study/reference/trajectory_divergence.h"

namespace plumb {
namespace {

MotionStatistics statistics_of(const ReferenceMotion& motion, const std::string& label, double step,
                               const Trajectory& run) {
  MotionStatistics result;
  result.label = label;
  result.parameter = motion.parameter;
  result.step = step;
  result.outcome = run.outcome;
  result.message = run.message;
  result.duration = run.end_time;
  if (run.outcome == Outcome::completed) take_statistics(motion.spec, run, result);
  return result;
}

Trajectory neighbour(const ReferenceMotion& motion, double time_limit) {
  const Cable cable(motion.spec);
  State start{0, cable.start_q(motion.spec.start), cable.start_v(motion.spec.start)};
  // The last node moves across all three axes, so that no direction of the motion is left out.
  Eigen::VectorXd change = Eigen::VectorXd::Zero(start.q.size());
  change.segment<3>(6 * cable.elements()).setConstant(start_distance * cable.length() / std::sqrt(3.0));
  cable.supports().apply(change);
  start.q += change;
  MethodSpec tight = plain_method(embedded_explicit());
  tight.parameters["order"] = 8;
  tight.rtol = tight.atol = 1e-11;
  return integrate(cable, start, tight, motion.spec.time, {}, time_limit);
}

}  // namespace

void take_statistics(const Case& spec, const Trajectory& run, MotionStatistics& statistics) {
  const Vec3 gravity = spec.loads.gravity;
  const Vec3 up = gravity.norm() > 0 ? Vec3(-gravity.normalized()) : Vec3(Vec3::UnitY());
  const auto count = static_cast<double>(run.times.size());
  const Eigen::Index tip = 6 * run.elements;
  double sum = 0, speeds = 0;
  for (std::size_t k = 0; k < run.times.size(); ++k) {
    sum += up.dot(run.q[k].segment<3>(tip));
    speeds += run.v[k].segment<3>(tip).squaredNorm();
  }
  statistics.mean_height = sum / count;
  double squares = 0;
  for (const Eigen::VectorXd& q : run.q)
    squares += std::pow(up.dot(q.segment<3>(tip)) - statistics.mean_height, 2);
  statistics.height_deviation = std::sqrt(squares / count);
  statistics.rms_speed = std::sqrt(speeds / count);
  const double scale = run.kinetic_scale();
  statistics.energy_change =
      scale > 0 ? (run.energies.back().total() - run.energies.front().total()) / scale : 0;
  statistics.taken = true;
}

std::vector<MotionStatistics> motion_statistics(const std::vector<const ReferenceMotion*>& motions,
                                                const std::vector<MethodSetting>& variants, double step,
                                                double time_limit) {
  std::vector<std::function<MotionStatistics()>> tasks;
  for (const ReferenceMotion* motion : motions) {
    if (motion->divergence.beyond_end || motion->divergence.horizon < 0) continue;
    tasks.emplace_back([=] { return statistics_of(*motion, "reference", 0, motion->trajectory); });
    tasks.emplace_back([=] {
      return statistics_of(*motion,
                           fmt::format("neighbour, {:g} of the length off at the start", start_distance), 0,
                           neighbour(*motion, time_limit));
    });
    for (const MethodSetting& variant : variants)
      if (variant.by_step && variant.info->family == MethodFamily::structural)
        tasks.emplace_back([=, &variant] {
          Case spec = motion->spec;
          spec.method = variant.with(step);
          return statistics_of(*motion, variant.label, step, integrate(spec, {}, time_limit));
        });
  }
  std::vector<MotionStatistics> result(tasks.size());
  for_each_in_parallel(tasks.size(), [&](std::size_t k) { result[k] = tasks[k](); });
  return result;
}

}  // namespace plumb
