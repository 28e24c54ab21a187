#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "render/plot/plot.h"
#include "report/figure/figures.h"

namespace plumb {

/// The `panels` of a figure in results.json: its series as numbers, and what a chart of them needs. A number
/// that is not finite is null. `times` are one for each panel, or none.
nlohmann::ordered_json panels_json(const Plot& plot, const std::vector<PanelTimes>& times);

}  // namespace plumb
