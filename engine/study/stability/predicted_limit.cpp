#include "engine/study/stability/predicted_limit.h"

#include <cmath>
#include <limits>

#include "engine/integrate/linear_stability.h"
#include "engine/model/cable.h"
#include "engine/study/stability/newton_contraction.h"

namespace plumb {

LimitKind limit_kind(const MethodSpec& method) {
  const auto limit = stability_limit(method);
  if (!limit) return LimitKind::none;
  if (*limit == 0) return LimitKind::always;
  return std::isfinite(*limit) ? LimitKind::vibration : LimitKind::contraction;
}

PredictedLimit vibration_limit(const MethodSpec& method, double frequency_at_start,
                               double frequency_at_worst) {
  const auto limit = stability_limit(method);
  if (!limit || *limit == 0) return {};
  const auto step = [&](double frequency) {
    return frequency > 0 ? *limit / frequency : std::numeric_limits<double>::infinity();
  };
  return {step(frequency_at_start), step(frequency_at_worst)};
}

PredictedLimit predicted_limit(const MethodSpec& method, const Cable& cable, const Trajectory& motion,
                               double frequency_at_start, double frequency_at_worst) {
  switch (limit_kind(method)) {
    case LimitKind::vibration:
      return vibration_limit(method, frequency_at_start, frequency_at_worst);
    case LimitKind::contraction:
      return motion.times.empty() ? PredictedLimit{} : contraction_limit(cable, method, motion);
    case LimitKind::none:
    case LimitKind::always:
      break;
  }
  return {};
}

}  // namespace plumb
