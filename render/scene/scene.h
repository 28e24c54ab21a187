#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/trajectory.h"
#include "render/gl/gl_context.h"
#include "render/gl/shapes.h"
#include "render/image/color.h"
#include "render/image/image.h"

namespace plumb {

class Cable;

/// A run as a scene shows it.
struct SceneRun {
  const Trajectory* trajectory = nullptr;  ///< must outlive what draws it
  double length = 0;                       ///< of the undeformed cable, m, > 0
  double radius = 0;  ///< true radius, m, ≥ 0; see SceneSpec::cable_radius for what is drawn
  SupportsSpec supports;
  std::string label;                        ///< beside its colour; may be empty
  std::optional<Color> color;               ///< default: the theme's for the first run, else the palette's
  Vec3 offset{0, 0, 0};                     ///< shown this far from where it is, m: side by side
  std::shared_ptr<const Cable> cable = {};  ///< that fields are computed with, where runs are coloured by one
};

/// Points that were published or measured, shown as small balls, each from its time on for as long as a
/// trail.
struct ScenePoints {
  std::string label;           ///< beside its colour; may be empty
  std::vector<double> times;   ///< s, rising
  std::vector<Vec3> places;    ///< m, as many
  std::optional<Color> color;  ///< default: the palette's
};

/// What a scene shows besides the motion.
struct SceneInput {
  SceneSpec spec;
  double length = 0;  ///< of the undeformed cable, m, > 0
  double radius = 0;  ///< true radius, m, ≥ 0; see SceneSpec::cable_radius for what is drawn
  SupportsSpec supports;
  Vec3 gravity{0, 0, 0};                    ///< m/s²; its direction is down
  std::string title;                        ///< may be empty
  std::shared_ptr<const Cable> cable = {};  ///< as in SceneRun
  std::string label = {};                   ///< of the run, where there are others beside it
  std::vector<SceneRun> others = {};        ///< over it, or by their offsets beside it
  std::vector<ScenePoints> points = {};
  std::string in_place_of_time = {};  ///< written where else the time is; empty: the time is
};

/// From a case, with the radius of the circle that has the cable's area.
SceneInput scene_input(const Case& the_case);
/// Another run of a case.
SceneRun scene_run(const Case& the_case, const Trajectory& trajectory, std::string label);

/// How many frames show a motion from 0 to `end` (s) at `frame_rate` (1/s); at least one, at most 1e9.
int frame_count(double end, double frame_rate);

/// Draws the moving cable: frames of an animation, or the picture at any time up to the last output.
class SceneRenderer {
 public:
  /// `context` and all trajectories must outlive it. Pictures larger than `largest_tile` pixels a side, or
  /// than the renderer can draw at once (0), are drawn in tiles. Throws OutputError when a run has no outputs
  /// or a state that is not finite, when the picture is too large, when the camera has no view, when runs are
  /// to be coloured but the first has no cable, or when points are not as many as their times.
  SceneRenderer(const GlContext& context, const Trajectory& trajectory, const SceneInput& input,
                int largest_tile = 0);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Frames at k / frame_rate, from 0 up to the last output; at least 1.
  int frame_count() const;
  /// Time of frame k in [0, frame_count()), s.
  double frame_time(int k) const;
  /// Throws OutputError when drawing fails.
  Image frame(int k);
  /// The same into a picture that was drawn before, whose memory is used again.
  void frame(int k, Image& picture);
  /// The picture at a time, s, kept inside the outputs'. Throws OutputError when drawing fails.
  Image at(double time);

  /// Where a place (m) is in the picture at a time, s; not finite when it is behind the camera.
  Point pixel(const Vec3& place, double time = 0) const;

 private:
  class Drawing;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace plumb
