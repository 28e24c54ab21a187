#pragma once

#include <vector>

#include "render/scene/camera.h"
#include "render/scene/motion.h"
#include "render/scene/surroundings.h"

namespace plumb {

/// Where the camera of a scene stands over time.
class CameraPath {
 public:
  /// For the cable that `motion` moves (which must outlive it) on a surroundings, drawn with `radius` (m), in
  /// pictures of an aspect, width by height.
  CameraPath(const SceneSpec& spec, const Surroundings& surroundings, const Motion& motion, double radius,
             double aspect, const ViewMargins& margins);

  bool moves() const { return view_ == View::orbit || view_ == View::follow; }
  CameraSpec at(double time) const;  ///< time in s

 private:
  const Motion& motion_;
  View view_;
  CameraSpec start_;  // of a camera that follows, relative to the cable's middle
  Vec3 up_;           // the axis of an orbit,
  Vec3 axis_;         // and a place on it
};

}  // namespace plumb
