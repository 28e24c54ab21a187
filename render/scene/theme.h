#pragma once

#include <array>

#include "engine/case/scene_settings.h"
#include "render/image/color.h"

namespace plumb {

/// The colours of a scene. Opaque unless said otherwise.
struct Theme {
  Color above;   ///< of the background, at the top
  Color below;   ///< and where the ground is
  Color plain;   ///< of a background of one colour
  Color grid;    ///< its opacity is that of a main line
  Color shadow;  ///< its opacity is that straight below a cable that touches the ground
  Color cable;
  std::array<Color, 5> series;  ///< of other runs and of points
  Color support;
  Color trail;
  Color ink;        ///< of texts
  Color quiet_ink;  ///< of what is less important
};

const Theme& theme(SceneTheme);

}  // namespace plumb
