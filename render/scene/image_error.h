#pragma once

#include <vector>

#include "render/scene/scene_camera.h"

namespace plumb {

/// Holds runs of one cable against another on the picture: the greatest distance between points of the
/// centre lines as they are drawn, in each frame, pixels. Points of equal arc length are compared, not
/// curves: that is never less than the distance of the curves, and it is what the trail of the tip and the
/// colours of a field show. Both are seen through the camera of the run that is taken for true, as a camera
/// that finds its own place would hide that it stands elsewhere. A pair of points of which neither is in the
/// picture, not even in part of the cable's breadth, does not count. Beside the frames count the last state
/// and `parts_of_a_frame` from frame to frame: what is right at the frames alone may be another motion.
class ImageErrorGauge {
 public:
  static constexpr int parts_of_a_frame = 4;

  /// `truth` must outlive it. Throws OutputError where it cannot be drawn.
  ImageErrorGauge(const Trajectory& truth, const SceneInput& input);

  /// One distance for each frame of the true run, since the frame before, and one for its end if that is
  /// after the last frame; infinite where the drawn one cannot be drawn, or is not as long, and where a point
  /// that should be in the picture is behind the camera. Empty where neither is ever in the picture.
  std::vector<double> distances(const Trajectory& drawn) const;

  const SceneCamera& camera() const { return camera_; }

 private:
  struct Sample {
    double time;        // s
    std::size_t frame;  // whose interval it is in
  };

  SceneCamera camera_;
  std::vector<Sample> samples_;
};

}  // namespace plumb
