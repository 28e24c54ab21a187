#pragma once

#include "render/scene/scene.h"

namespace plumb {

/// How the first picture of a scene is seen.
struct ViewAxes {
  Vec3 right;             ///< unit vector to the right of the picture, level where the picture has such a way
  Vec3 back;              ///< unit vector from what is seen to the eye
  bool parallel = false;  ///< by parallel rays, which `back` is then the way of throughout
};

/// Of a run in the scene of `input` without others. Throws OutputError when the run cannot be drawn.
ViewAxes view_axes(const Trajectory& trajectory, const SceneInput& input);

/// Puts a run to the side of what is there already: moves it (its offset) along `right`, so that it begins a
/// quarter of its length after `end`, the greatest place along `right` (m) of what is there. Returns the end
/// of all with it, m. Throws OutputError when the run cannot be drawn.
double put_beside(SceneRun& run, const Vec3& right, double end);

/// The greatest place of a run along a direction, m. Throws OutputError when the run cannot be drawn.
double reach_along(const Trajectory& trajectory, const Vec3& direction);

}  // namespace plumb
