#pragma once

#include <memory>
#include <string>

#include "engine/input/case.h"
#include "engine/integrate/trajectory.h"
#include "render/gl_context.h"
#include "render/image.h"
#include "render/shapes.h"

namespace plumb {

/// What a scene shows besides the motion.
struct SceneInput {
  SceneSpec spec;
  double length = 0;  ///< of the undeformed cable, m, > 0
  double radius = 0;  ///< true radius, m, ≥ 0; see SceneSpec::cable_radius for what is drawn
  SupportsSpec supports;
  Vec3 gravity{0, 0, 0};  ///< m/s²; its direction is down
  std::string title;      ///< may be empty
};

/// From a case, with the radius of the circle that has the cable's area.
SceneInput scene_input(const Case& the_case);

/// Draws the moving cable: frames of an animation, or the picture at any time up to the last output.
class SceneRenderer {
 public:
  /// `context` and `trajectory` must outlive it. Throws OutputError when the run has no outputs or a state
  /// that is not finite, when the picture is too large, or when the camera has no view.
  SceneRenderer(const GlContext& context, const Trajectory& trajectory, const SceneInput& input);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Frames at k / frame_rate, from 0 up to the last output; at least 1.
  int frame_count() const;
  /// Time of frame k in [0, frame_count()), s.
  double frame_time(int k) const;
  /// Throws OutputError when drawing fails.
  Image frame(int k);
  /// The picture at a time, s, kept inside the outputs'. Throws OutputError when drawing fails.
  Image at(double time);

  /// Where a place (m) is in the pictures; not finite when it is behind the camera.
  Point pixel(const Vec3& place) const;

 private:
  class Drawing;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace plumb
