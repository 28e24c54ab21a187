#pragma once

#include <memory>
#include <vector>

#include "render/image/color.h"
#include "render/scene/camera.h"
#include "render/scene/motion.h"
#include "render/scene/scene.h"
#include "render/scene/tube.h"

namespace plumb {

class Cable;

/// The least and the greatest value of a field.
struct FieldRange {
  double lo = 0;
  double hi = 0;
};

/// One run in a scene, made into what is drawn of it.
class DrawnCable {
 public:
  /// `radius` as drawn, m, > 0. `field` colours it where the run has a cable. Throws OutputError where the
  /// run cannot be drawn (see Motion) or its cable is another.
  DrawnCable(const SceneRun& run, double radius, ColorField field);

  const Motion& motion() const { return motion_; }
  double radius() const { return radius_; }
  const SupportsSpec& supports() const { return supports_; }

  /// By how few points the cable in a state can be drawn.
  std::vector<CurvePoint> curve(const State& state, const Camera& camera) const;
  /// The field's range over the whole run.
  FieldRange field_range() const;
  /// The field along a curve in a state, as shares of a range from 0 to 1; nothing where there is no field.
  std::vector<float> levels(const std::vector<CurvePoint>& curve, const State& state, FieldRange range) const;

  /// Takes down the tip's way through the run, by places `interval` s apart, so that each frame can take its
  /// stretch of it.
  void keep_trail(double interval);
  /// The tip's way from one time to another, s; its last place is that in `state`, of the later time.
  std::vector<Vec3> trail(double from, double to, const State& state) const;

 private:
  double value(const State& state, double place) const;

  Motion motion_;
  double radius_;
  SupportsSpec supports_;
  std::shared_ptr<const Cable> cable_;
  ColorField field_;
  double trail_interval_ = 0;  // s
  std::vector<Vec3> tip_path_;
};

}  // namespace plumb
