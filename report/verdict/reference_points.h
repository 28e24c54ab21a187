#pragma once

#include <string>
#include <vector>

#include "engine/run/run.h"
#include "render/scene/scene.h"

namespace plumb {

/// Points of the references of a run, as far as a scene can show them.
struct ReferencePoints {
  std::vector<ScenePoints> series;
  std::vector<std::string> left_out;  ///< why not, for each probe that a reference is held against
};

/// A reference gives points where it is held against all three components of a probe's position. Two are
/// enough where the scene is seen by parallel rays along the third; the points are then shown in front of the
/// cable, as their depth is not known. `motion` is what the scene shows of the run. Throws OutputError when
/// it cannot be drawn.
ReferencePoints reference_points(const Run& run, const Trajectory& motion, const SceneInput& scene);

}  // namespace plumb
