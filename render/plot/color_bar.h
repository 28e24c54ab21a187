#pragma once

#include "render/gl/painter.h"
#include "render/plot/plot_layout.h"
#include "render/plot/plot_theme.h"

namespace plumb {

/// The bar of a heat map's colours beside a panel from `top` to `bottom`, its places along x
/// counted from the panel's right end, without the base of the power of ten.
ColorBarLayout color_bar_layout(const HeatMap& map, double top, double bottom, const PlotSizes& sizes,
                                const Font& font);

/// What a bar needs to the right of its panel, pixels.
double color_bar_width(const HeatMap& map, const ColorBarLayout& bar, const PlotSizes& sizes,
                       const Font& font);

void draw_color_bar(Painter& painter, const HeatMap& map, const ColorBarLayout& bar, const PlotSizes& sizes,
                    const PlotTheme& theme);

}  // namespace plumb
