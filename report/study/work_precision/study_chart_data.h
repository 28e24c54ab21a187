#pragma once

#include <string>

#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// All that the charts of a page show, as JSON on one line: runs with their errors, counts and times, curves
/// with their looks, fronts and floors. What was not counted or taken is null.
std::string study_chart_data(const WorkPrecision& study);

/// JSON for within an HTML script element, where no "</script" or "<!--" may be.
std::string escape_json_for_html(const std::string& json);

}  // namespace plumb
