#pragma once

#include <limits>
#include <vector>

#include "render/scene/camera.h"
#include "render/scene/motion.h"

namespace plumb {

/// The cable in a state by as few of its points as the picture needs: nowhere is the curve further than
/// `tolerance` pixels from the chords between them, and no chord is longer than `longest` elements. Both ends
/// are among them.
std::vector<CurvePoint> visible_curve(const Motion& motion, const Eigen::VectorXd& state,
                                      const Camera& camera, double tolerance,
                                      double longest = std::numeric_limits<double>::infinity());

}  // namespace plumb
