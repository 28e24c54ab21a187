#include "engine/integrate/methods/step_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr double safety = 0.9;
constexpr double least_change = 0.2, greatest_change = 5;
// Smaller errors would make the factor jump.
constexpr double least_size = 1e-4;

}  // namespace

StepControl::StepControl(double rtol, double atol, double length, int order, double duration)
    : position_scale_((rtol + atol) * length),
      slope_scale_(rtol + atol),
      duration_(duration),
      exponent_(1.0 / (duration > 0 ? order : order + 1)) {}

double StepControl::tolerance_ratio(double steps) const {
  return std::pow(steps, 1 / exponent_);
}

double StepControl::size(const Eigen::VectorXd& error, double h) const {
  double greatest = 0;
  for (Eigen::Index i = 0; i < error.size(); i += 6) {
    const double size = std::max(error.segment<3>(i).lpNorm<Eigen::Infinity>() / position_scale_,
                                 error.segment<3>(i + 3).lpNorm<Eigen::Infinity>() / slope_scale_);
    if (!std::isfinite(size) || !error.segment<6>(i).allFinite())
      return std::numeric_limits<double>::infinity();
    greatest = std::max(greatest, size);
  }
  return duration_ > 0 ? greatest * duration_ / h : greatest;
}

double StepControl::first_step(const Eigen::VectorXd& a, double end) const {
  // The way that the acceleration makes in it is a hundredth of the tolerance: too short, but growing fast.
  const double per_square = size(a, duration_);
  const double shortest = 1e-9 * end;
  if (!(per_square > 0)) return std::max(1e-3 * end, shortest);
  return std::clamp(std::sqrt(0.02 / per_square), shortest, end);
}

double StepControl::next(double h, double size) const {
  if (!std::isfinite(size)) return after_failure(h);
  const double now = std::max(size, least_size);
  const double factor = now > 1 ? std::min(safety * std::pow(now, -exponent_), safety)
                                : safety * std::pow(now, -0.7 * exponent_) * std::pow(last_, 0.4 * exponent_);
  return h * std::clamp(factor, least_change, greatest_change);
}

void StepControl::accept(double size) {
  last_ = std::max(size, least_size);
}

}  // namespace plumb
