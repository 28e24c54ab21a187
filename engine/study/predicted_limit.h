#pragma once

#include "engine/integrate/method_info.h"
#include "engine/study/stability.h"

namespace plumb {

/// What the limit of a method rests on.
LimitKind limit_kind(const MethodSpec& method);

/// The step beyond which a vibration of these frequencies (rad/s) grows, by the method's stability limit.
/// Infinite where it never grows.
PredictedLimit vibration_limit(const MethodSpec& method, double frequency_at_start,
                               double frequency_at_worst);

}  // namespace plumb
