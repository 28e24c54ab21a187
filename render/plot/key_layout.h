#pragma once

#include "render/gl/painter.h"
#include "render/plot/plot_layout.h"
#include "render/plot/plot_theme.h"

namespace plumb {

struct KeyLayout {
  std::vector<KeyEntry> entries;
  double height = 0;  ///< pixels, with the gap below; 0 for an empty key
};

/// The key of a plot in rows from `top`, centred in `width`.
KeyLayout key_layout(const PlotKey& key, double top, double width, const PlotSizes& sizes, const Font& font);

void draw_key(Painter& painter, const PlotKey& key, const std::vector<KeyEntry>& entries,
              const PlotSizes& sizes, const PlotTheme& theme);

}  // namespace plumb
