#pragma once

#include <vector>

#include "engine/study/stability/stability.h"
#include "render/plot/plot.h"

namespace plumb {

/// Where the cells of values, rising and above 0, begin and end: halfway by ratio between neighbours, and as
/// far beyond the outer ones. One more than values.
std::vector<double> edges_between(const std::vector<double>& values);

/// A map of outcomes as a panel with the predicted limits over it; `title` may be empty. Its categories are
/// those of map_key().
Panel map_panel(const Stability& study, const OutcomeMap& map, const std::string& title);

/// What is said once of the panels of these maps: the outcomes that occur, and the limits where there are
/// any.
PlotKey map_key(const std::vector<const OutcomeMap*>& maps);

}  // namespace plumb
