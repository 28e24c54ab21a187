#pragma once

#include <array>

#include "engine/case/scene_settings.h"
#include "render/image/color.h"

namespace plumb {

/// The colours of a plot.
struct PlotTheme {
  Color paper;
  Color ink;
  Color major_grid;
  Color minor_grid;
  Color zero;      ///< of a line at 0
  Color rule;      ///< of rules that have no colour of their own
  Color rule_ink;  ///< of their labels
  std::array<Color, palette.size()> series;
  double least_contrast;  ///< of series; more on dark paper, where the same ratio looks dimmer
};

const PlotTheme& plot_theme(SceneTheme);

/// Contrast of two opaque colours, 1 to 21: the ratio of relative luminances of the W3C's Web Content
/// Accessibility Guidelines 2.1, which ask for 4.5 of text and 3 of graphics.
double contrast(Color a, Color b);

/// A colour that has at least the theme's contrast to its paper: the one given, or it mixed with as much ink
/// as is needed. Its opacity stays.
Color seen_on(const PlotTheme& theme, Color color);

}  // namespace plumb
