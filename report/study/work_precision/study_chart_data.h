#pragma once

#include <string>

#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// All that the charts of a page show, as JSON on one line: runs with their errors, counts and times, curves
/// with their looks, fronts and floors. What was not counted or taken is null.
std::string study_chart_data(const WorkPrecision& study);

}  // namespace plumb
