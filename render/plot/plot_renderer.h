#pragma once

#include "render/gl/painter.h"
#include "render/image/image.h"
#include "render/plot/plot.h"

namespace plumb {

/// Draws plots. Keeps its fonts and shaders, so one serves for many.
class PlotRenderer {
 public:
  /// `context` must outlive it. Throws OutputError when a font is missing or a shader is refused.
  explicit PlotRenderer(const GlContext& context);

  /// Throws OutputError when the plot cannot be laid out (see plot_layout) or drawn.
  Image draw(const Plot& plot);

 private:
  const GlContext& context_;
  Painter painter_;
};

}  // namespace plumb
