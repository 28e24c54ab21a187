#pragma once

#include <functional>
#include <vector>

#include "engine/study/reference/method_settings.h"
#include "engine/study/reference/reference_motion.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// Sets mean and deviation of the height of the last end and the root mean square of its speed over the
/// outputs of a run, which must have some. Height is against gravity, along Y without gravity.
void take_statistics(const Case& spec, const Trajectory& run, MotionStatistics& statistics);

/// Statistics of motions beyond their horizon, where neighbours part and only such can be compared: of the
/// reference, of a start a node of which is `start_distance` off, and of the structural schemes among
/// `variants` with one step (s). Motions whose horizon is not reached have none.
std::vector<MotionStatistics> motion_statistics(const std::vector<const ReferenceMotion*>& motions,
                                                const std::vector<MethodSetting>& variants, double step,
                                                double time_limit);

}  // namespace plumb
