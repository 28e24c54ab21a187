#pragma once

#include "render/gl/painter.h"
#include "render/plot/plot_layout.h"

namespace plumb {

/// Throws OutputError where edges do not rise, values and edges differ in number, or a given range is not
/// one.
void check_heat_map(const HeatMap& map);

/// The values that the ends of the colours stand for, lo < hi.
AxisRange color_range(const HeatMap& map);

/// The colour of a value; those beyond the range have the ends'.
Color color_of(const HeatMap& map, const AxisRange& range, double value);

/// Fills the frame of a panel.
void draw_heat_map(Painter& painter, const HeatMap& map, const PanelLayout& panel);

}  // namespace plumb
