#pragma once

#include <string>
#include <vector>

#include "engine/output/run.h"
#include "render/scene.h"

namespace plumb {

/// Another run that is shown with one.
struct OtherRun {
  std::string path;  ///< as the user named it
  Run run;
  bool beside = false;  ///< to the right of what is there, rather than over it
};

/// Adds other runs to the scene of a motion, each in its colour and labelled by its folder, or where two
/// folders have one name by its path. Both `motion` and `others` must outlive what draws it. `path` is that
/// of the motion's run. Throws InputError naming the run where one cannot be drawn or does not end when the
/// motion does.
void add_other_runs(SceneInput& scene, const std::string& path, const Trajectory& motion,
                    const std::vector<OtherRun>& others);

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
