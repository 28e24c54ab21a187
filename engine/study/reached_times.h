#pragma once

#include <vector>

#include "engine/input/reference.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// The times of a reference, from its first on, that are within a case's end and that a run reached, s. One
/// beyond the last output by no more than rounding is that output.
std::vector<double> reached_times(const Reference& reference, const TimeSpec& time, const Trajectory& run);

}  // namespace plumb
