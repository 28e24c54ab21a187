#pragma once

#include <Eigen/Core>
#include <span>

#include "engine/case/case.h"
#include "render/gl/shapes.h"

namespace plumb {

/// A view into a picture: in perspective, or by parallel rays where the view's height is given.
class Camera {
 public:
  /// Width and height of the picture in pixels. `center` and `radius` (m) enclose what has to be inside the
  /// depth range. Throws OutputError when the view has no direction or `up` is along it.
  Camera(const CameraSpec& spec, int width, int height, const Vec3& center, double radius);

  bool is_parallel() const { return view_height_ > 0; }
  /// From world to clip coordinates, which OpenGL divides by w.
  const Eigen::Matrix4d& matrix() const { return matrix_; }
  const Vec3& eye() const { return eye_; }
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }
  /// From the target to the eye, a unit vector.
  const Vec3& back() const { return back_; }

  /// Where a place is seen; not finite when it is not in front of the camera. Parallel rays have no front.
  Point pixel(const Vec3& place) const;
  /// Pixels that a metre across the view has at the distance of a place; with parallel rays everywhere.
  double pixels_per_metre(const Vec3& place) const;

 private:
  Eigen::Matrix4d matrix_;
  Vec3 eye_;
  Vec3 right_;
  Vec3 up_;
  Vec3 back_;
  double width_;
  double height_;
  double view_height_;  // m; 0: perspective
  double focal_;        // pixels; with parallel rays a metre
};

/// The part of a picture that a motion may fill, as fractions of half its width and height from the middle.
struct ViewMargins {
  double side = 0.88;
  double top = 0.80;
  double bottom = 0.84;
};

/// The camera that looks along -back with the given `up` and stands as near as all points, each with a ball
/// of `radius` (m) around it, allow. `back` is a unit vector not along `up`. There must be at least one
/// point.
CameraSpec fitted_camera(std::span<const Vec3> points, double radius, const Vec3& back, const Vec3& up,
                         double aspect, const ViewMargins& margins);

/// The same with parallel rays: as little is in view as the points allow.
CameraSpec fitted_parallel_camera(std::span<const Vec3> points, double radius, const Vec3& back,
                                  const Vec3& up, double aspect, const ViewMargins& margins);

}  // namespace plumb
