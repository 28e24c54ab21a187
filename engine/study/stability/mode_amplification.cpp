#include "engine/study/stability/mode_amplification.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include "engine/base/dense.h"
#include "engine/base/parallel.h"
#include "engine/integrate/dynamics.h"
#include "engine/integrate/linear_stability.h"
#include "engine/integrate/method.h"
#include "engine/model/cable.h"
#include "engine/model/greatest_eigenfrequency.h"

namespace plumb {
namespace {

/// A free vibration of a cable about its straight state.
struct Mode {
  Cable cable;
  Eigen::VectorXd straight;
  FastestVibration vibration;
  double amplitude;  // of the coordinate along the shape
};

Mode fastest_mode(Case spec) {
  constexpr double strain = 1e-7;
  spec.loads = {};
  spec.damping = {};
  spec.supports = {.first = spec.supports.first, .last = spec.supports.last};
  Cable cable(spec);
  Eigen::VectorXd straight = cable.start_q(spec.start);
  FastestVibration vibration = fastest_vibration(cable, straight);
  const double greatest = vibration.shape.lpNorm<Eigen::Infinity>();
  const double amplitude = greatest > 0 ? strain * cable.element().length() / greatest : 0;
  return {std::move(cable), std::move(straight), std::move(vibration), amplitude};
}

/// How many steps show the growth well: until the amplitude is far from what it was, but not below what
/// Newton's tolerance leaves, nor large.
int steps_to_watch(double growth, int steps_a_period) {
  constexpr double greatest_change = 3e3;
  constexpr int fewest = 12, most_periods = 40;
  const double rate = std::abs(std::log(std::max(growth, 1e-300)));
  const double enough = rate > 0 ? std::log(greatest_change) / rate : INFINITY;
  return static_cast<int>(std::clamp<double>(enough, fewest, most_periods * steps_a_period));
}

/// Beginnings of methods with memory, and quickly damped numerical vibrations, are left out.
std::vector<double> settled(const std::vector<double>& series) {
  return {series.begin() + static_cast<std::ptrdiff_t>(series.size() / 2), series.end()};
}

ModeAmplification measure(const MethodSetting& variant, const Mode& mode, int steps_a_period) {
  const double step = 2 * std::numbers::pi / (mode.vibration.frequency * steps_a_period);
  MethodSpec method = variant.with(step);
  // Its smallest: the vibration is small itself.
  for (const MethodParameter& parameter : variant.info->parameters)
    if (parameter.name == "newton_tolerance") method.parameters[parameter.name] = parameter.minimum;
  const double growth = *amplification(method, mode.vibration.frequency * step);
  const int steps = steps_to_watch(growth, steps_a_period);

  State start{0, mode.straight, Eigen::VectorXd::Zero(mode.straight.size())};
  start.q += mode.amplitude * mode.vibration.shape;
  ModeAmplification result;
  result.label = variant.label;
  result.steps_a_period = steps_a_period;
  result.predicted = std::pow(growth, steps_a_period);
  Eigen::VectorXd weighted(mode.straight.size());
  mode.cable.mass().multiply(mode.vibration.shape, weighted);
  // Not by integrate(), which ends a run as soon as its vibration has grown by a fifth.
  Dynamics dynamics(mode.cable);
  const std::unique_ptr<Method> integrator = make_method(method, dynamics, start);
  std::vector<double> series;
  for (int k = 0; k < steps; ++k) {
    if (!integrator->step(steps * step).ok()) return result;
    series.push_back(weighted.dot(integrator->state().q - mode.straight) / mode.amplitude);
  }
  const double seen = growth_a_step(settled(series));
  if (seen >= 0) result.measured = std::pow(seen, steps_a_period);
  return result;
}

}  // namespace

double growth_a_step(const std::vector<double>& series) {
  constexpr std::size_t fewest = 4;
  if (series.size() < fewest) return -1;
  const auto rows = static_cast<Eigen::Index>(series.size() - 2);
  const Eigen::Map<const Eigen::VectorXd> x(series.data(), static_cast<Eigen::Index>(series.size()));
  Eigen::MatrixXd before(rows, 2);
  before << x.segment(1, rows), x.head(rows);
  if (!before.allFinite() || !(before.norm() > 0)) return -1;
  // Each row counts alike, however much the vibration has grown by then.
  Eigen::VectorXd after = x.tail(rows);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const double scale = before.row(k).norm();
    if (!(scale > 0)) continue;
    before.row(k) /= scale;
    after[k] /= scale;
  }
  const Eigen::VectorXd fit = least_squares(before, after).x;
  const std::complex<double> root = std::sqrt(std::complex<double>(fit[0] * fit[0] / 4 + fit[1]));
  return std::max(std::abs(fit[0] / 2 + root), std::abs(fit[0] / 2 - root));
}

std::vector<ModeAmplification> mode_amplifications(const std::vector<MethodSetting>& variants,
                                                   const Case& spec, const std::vector<int>& steps_a_period) {
  const Mode mode = fastest_mode(spec);
  if (!(mode.vibration.frequency > 0)) return {};
  std::vector<std::pair<const MethodSetting*, int>> chosen;
  for (const MethodSetting& variant : variants)
    if (variant.by_step && amplification(variant.with(1), 1))
      for (const int steps : steps_a_period) chosen.emplace_back(&variant, steps);
  std::vector<ModeAmplification> results(chosen.size());
  for_each_in_parallel(
      chosen.size(), [&](std::size_t k) { results[k] = measure(*chosen[k].first, mode, chosen[k].second); });
  return results;
}

}  // namespace plumb
