#pragma once

#include <optional>
#include <vector>

#include "render/scene/camera_path.h"
#include "render/scene/motion.h"
#include "render/scene/scene.h"
#include "render/scene/surroundings.h"

namespace plumb {

/// Radius of the cable as a scene draws it, m, from the true one and the length of the cable.
double drawn_radius(const SceneSpec& spec, double length, double radius);

/// The camera through which a scene of one run shows it, without anything to draw with.
class SceneCamera {
 public:
  /// `run` must outlive it. Throws OutputError where the run cannot be drawn or the camera has no view.
  SceneCamera(const Trajectory& run, const SceneInput& input);
  SceneCamera(const SceneCamera&) = delete;
  SceneCamera& operator=(const SceneCamera&) = delete;

  Camera at(double time) const;  ///< time in s
  const Motion& motion() const { return motion_; }
  double radius() const { return radius_; }  ///< as drawn, m
  int width() const { return width_; }       ///< pixels
  int height() const { return height_; }     ///< pixels
  /// Times of the frames, s: k / frame_rate up to the last output.
  std::vector<double> frame_times() const;

 private:
  Motion motion_;
  double radius_;
  int width_;
  int height_;
  double frame_rate_;
  Surroundings surroundings_;
  std::optional<CameraPath> path_;
};

}  // namespace plumb
