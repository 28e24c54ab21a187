#include "render/scene/camera_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plumb {

namespace {

// Places turned once around an axis, by rings that enclose them.
std::vector<Vec3> turned_around(const std::vector<Vec3>& places, const Surroundings& surroundings,
                                const Vec3& axis) {
  constexpr int bins = 64, steps = 32;
  double low = surroundings.height(places.front());
  double high = low;
  for (const Vec3& place : places) {
    low = std::min(low, surroundings.height(place));
    high = std::max(high, surroundings.height(place));
  }
  const double bin = std::max((high - low) / bins, 1e-300);
  std::array<double, bins> reach{};
  for (const Vec3& place : places) {
    const Vec3 from_axis = surroundings.on_ground(place) - surroundings.on_ground(axis);
    const auto k =
        static_cast<std::size_t>(std::clamp((surroundings.height(place) - low) / bin, 0.0, bins - 1.0));
    reach[k] = std::max(reach[k], from_axis.norm());
  }
  std::vector<Vec3> rings;
  for (int k = 0; k < bins; ++k)
    for (const int edge : {k, k + 1})
      for (int i = 0; i < steps; ++i) {
        const double angle = 2 * std::numbers::pi * i / steps;
        // The polygon's sides, rather than its corners, are as far away as the places.
        const double radius = reach[static_cast<std::size_t>(k)] / std::cos(std::numbers::pi / steps);
        rings.push_back(surroundings.on_ground(axis) + surroundings.up * (low + edge * bin) +
                        radius *
                            (std::cos(angle) * surroundings.across + std::sin(angle) * surroundings.forward));
      }
  return rings;
}

// The cable in all outputs relative to its middle, mirrored so that a view fitted to it has that in its
// middle.
std::vector<Vec3> around_middle(const Motion& motion, const Vec3& back, const Vec3& up) {
  constexpr std::size_t enough = 500;
  constexpr int along = 48;
  const Vec3 right = up.cross(back).normalized();
  const Vec3 upward = back.cross(right);
  const std::size_t stride = std::max<std::size_t>(1, motion.output_count() / enough);
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < motion.output_count(); i += stride) {
    const Vec3 middle = motion.middle(motion.output(i));
    for (int k = 0; k <= along; ++k) {
      const Vec3 place =
          motion.point(motion.output(i), 1.0 * motion.elements() * k / along).position - middle;
      const double x = place.dot(right), y = place.dot(upward), depth = place.dot(back);
      for (const double sx : {-1.0, 1.0})
        for (const double sy : {-1.0, 1.0}) places.push_back(sx * x * right + sy * y * upward + depth * back);
    }
  }
  return places;
}

}  // namespace

CameraPath::CameraPath(const SceneSpec& spec, const Surroundings& surroundings, const Motion& motion,
                       double radius, double aspect, const ViewMargins& margins)
    : motion_(motion),
      view_(spec.camera ? View::fit : spec.view),
      up_(surroundings.up),
      axis_(surroundings.origin + surroundings.middle.x() * surroundings.across +
            surroundings.middle.y() * surroundings.forward) {
  const double around = 3 * radius;  // of the centre line: the tube, its supports, and some air
  const auto along_axis = [&](const Vec3& back, const Vec3& up) {
    return fitted_parallel_camera(surroundings.places, around, back, up, aspect, margins);
  };
  if (spec.camera) {
    start_ = *spec.camera;
    return;
  }
  switch (view_) {
    case View::fit:
      start_ = fitted_camera(surroundings.places, around, surroundings.best_side, up_, aspect, margins);
      break;
    case View::front:
      start_ = along_axis(surroundings.forward, up_);
      break;
    case View::back:
      start_ = along_axis(-surroundings.forward, up_);
      break;
    case View::left:
      start_ = along_axis(-surroundings.across, up_);
      break;
    case View::right:
      start_ = along_axis(surroundings.across, up_);
      break;
    case View::top:
      start_ = along_axis(up_, -surroundings.forward);
      break;
    case View::bottom:
      start_ = along_axis(-up_, surroundings.forward);
      break;
    case View::orbit:
      start_ = fitted_camera(turned_around(surroundings.places, surroundings, axis_), around,
                             surroundings.best_side, up_, aspect, margins);
      break;
    case View::follow: {
      ViewMargins even = margins;
      even.top = even.bottom = std::min(margins.top, margins.bottom);
      start_ = fitted_camera(around_middle(motion, surroundings.best_side, up_), around,
                             surroundings.best_side, up_, aspect, even);
      break;
    }
  }
}

CameraSpec CameraPath::at(double time) const {
  CameraSpec spec = start_;
  if (view_ == View::orbit) {
    const double share = motion_.end() > 0 ? time / motion_.end() : 0;
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * share, up_);
    spec.eye = axis_ + turn * (start_.eye - axis_);
    spec.target = axis_ + turn * (start_.target - axis_);
  } else if (view_ == View::follow) {
    const Vec3 middle = motion_.middle(motion_.state(time));
    spec.eye += middle;
    spec.target += middle;
  }
  return spec;
}

}  // namespace plumb
