#pragma once

#include "engine/integrate/method_info.h"
#include "engine/study/stability/stability.h"

namespace plumb {

class Cable;

/// What the limit of a method rests on.
LimitKind limit_kind(const MethodSpec& method);

/// The step beyond which a vibration of these frequencies (rad/s) grows, by the method's stability limit.
/// Infinite where it never grows.
PredictedLimit vibration_limit(const MethodSpec& method, double frequency_at_start,
                               double frequency_at_worst);

/// The limit that the method's kind has on a cable that moves as `motion` does: of its vibrations, or of the
/// contraction of its Newton iteration. -1 where nothing is predicted.
PredictedLimit predicted_limit(const MethodSpec& method, const Cable& cable, const Trajectory& motion,
                               double frequency_at_start, double frequency_at_worst);

}  // namespace plumb
