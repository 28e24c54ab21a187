#pragma once

#include <string>
#include <vector>

#include "render/plot/plot_layout.h"

namespace plumb {

/// Those of the given values, ascending, that are inside the axis, with their own labels or, where there are
/// none, their values; a label that would overlap the one before is empty.
AxisTicks given_ticks(const AxisMap& axis, const std::vector<double>& values,
                      const std::vector<std::string>& labels, const TickRoom& room);

}  // namespace plumb
