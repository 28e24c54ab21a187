#pragma once

#include <string>
#include <vector>

#include "engine/run/run.h"
#include "render/scene/scene.h"

namespace plumb {

/// Another run that is shown with one.
struct OtherRun {
  std::string path;  ///< as the user named it
  Run run;
  bool beside = false;  ///< to the right of what is there, rather than over it
};

/// What runs are called by: each by its folder, or where two folders have one name by its path.
std::vector<std::string> labels_of_runs(const std::vector<std::string>& paths);

/// Adds other runs to the scene of a motion, each in its colour and labelled as above. Both `motion` and
/// `others` must outlive what draws it. `path` is that of the motion's run. Throws InputError naming the run
/// where one cannot be drawn or does not end when the motion does.
void add_other_runs(SceneInput& scene, const std::string& path, const Trajectory& motion,
                    const std::vector<OtherRun>& others);

}  // namespace plumb
