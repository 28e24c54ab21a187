#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/gl/painter.h"
#include "render/scene/camera.h"

namespace plumb {

/// A name beside its colour.
struct FrameLabel {
  std::string text;
  Color color;
  Marker marker = Marker::none;  ///< none: a line
};

/// What the colours of a cable mean.
struct ColorBar {
  std::string title;  ///< "axial strain"
  std::string unit;   ///< "1"
  double lo = 0;      ///< < hi
  double hi = 1;
};

/// What is written in a frame.
struct FrameTexts {
  std::string title;            ///< may be empty
  std::string time;             ///< "t = 0.52 s"
  double pixels_per_metre = 0;  ///< of the scale bar, > 0
  std::vector<FrameLabel> labels;
  std::optional<ColorBar> bar;
  Color ink;
  Color quiet_ink;
};

/// Height of the texts of a picture, pixels; 0 where it is so small that it has none.
double frame_text_size(int width, int height);

/// What a motion has to keep clear of in a picture.
ViewMargins margins_beside(const FrameTexts& texts, int width, int height);

/// Draws them on a picture of this size, of which the painter's canvas is all or a part.
void draw_texts(Painter& painter, const FrameTexts& texts, int width, int height);

}  // namespace plumb
