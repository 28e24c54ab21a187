#pragma once

#include "render/plot/plot_layout.h"

namespace plumb {

/// Places that the panel's data reach, a few pixels apart.
std::vector<Point> data_samples(const Panel& panel, const PanelLayout& layout, double apart);

/// A panel's legend in the inner place where it covers the least of the data, or nothing if none would be
/// free enough or no series has a label. Long ones have columns.
std::optional<LegendLayout> legend_inside(const Panel& panel, const PanelLayout& layout,
                                          const PlotSizes& sizes, const Font& font);

/// A legend of the given width, in one row or in columns; its box starts at (left, top).
LegendLayout legend_rows(const Panel& panel, double left, double top, double width, const PlotSizes& sizes,
                         const Font& font);

}  // namespace plumb
