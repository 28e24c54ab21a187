#pragma once

#include "render/plot_layout.h"

namespace plumb {

/// A panel's legend in the inner place where it covers the least of the data, or nothing if none would be
/// free enough or no series has a label.
std::optional<LegendLayout> legend_inside(const Panel& panel, const PanelLayout& layout,
                                          const PlotSizes& sizes, const Font& font);

/// A legend in rows of the given width; its box starts at (left, top).
LegendLayout legend_rows(const Panel& panel, double left, double top, double width, const PlotSizes& sizes,
                         const Font& font);

}  // namespace plumb
