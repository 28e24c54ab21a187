#pragma once

#include "render/plot/plot_layout.h"

namespace plumb {

/// Where the rules of a panel go whose frame and axes are placed; those outside its ranges are left out.
std::vector<RuleLayout> rule_layouts(const Panel& panel, const PanelLayout& layout, const PlotSizes& sizes,
                                     const Font& font);

}  // namespace plumb
