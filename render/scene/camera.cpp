#include "render/scene/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/errors.h"

namespace plumb {

namespace {

double half_tangent(double field_of_view) {
  return std::tan(field_of_view * std::numbers::pi / 360);
}

}  // namespace

Camera::Camera(const CameraSpec& spec, int width, int height, const Vec3& center, double radius)
    : eye_(spec.eye), width_(width), height_(height), view_height_(spec.view_height) {
  const double distance = (spec.eye - spec.target).norm();
  if (!(distance > 0)) throw OutputError("scene.camera: eye and target are the same place");
  back_ = (spec.eye - spec.target) / distance;
  right_ = spec.up.cross(back_);
  if (!(right_.norm() > 1e-9 * spec.up.norm())) throw OutputError("scene.camera: up is along the view");
  right_.normalize();
  up_ = back_.cross(right_);

  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.row(0).head<3>() = right_;
  view.row(1).head<3>() = up_;
  view.row(2).head<3>() = back_;
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye_;

  const double depth = (eye_ - center).dot(back_);
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  if (is_parallel()) {
    focal_ = height_ / view_height_;
    projection(0, 0) = 2 * height_ / width_ / view_height_;
    projection(1, 1) = 2 / view_height_;
    projection(2, 2) = -1 / radius;
    projection(2, 3) = -depth / radius;
    projection(3, 3) = 1;
  } else {
    const double tangent = half_tangent(spec.field_of_view);
    const double far = std::max(depth + radius, 2e-3 * distance);
    const double near = std::max(depth - radius, 1e-3 * far);
    focal_ = height_ / 2 / tangent;
    projection(0, 0) = height_ / width_ / tangent;
    projection(1, 1) = 1 / tangent;
    projection(2, 2) = -(far + near) / (far - near);
    projection(2, 3) = -2 * far * near / (far - near);
    projection(3, 2) = -1;
  }
  matrix_ = projection * view;
}

Point Camera::pixel(const Vec3& place) const {
  const Eigen::Vector4d clip = matrix_ * place.homogeneous();
  if (!(clip.w() > 0)) return Point::Constant(std::numeric_limits<double>::quiet_NaN());
  return {(clip.x() / clip.w() + 1) / 2 * width_, (1 - clip.y() / clip.w()) / 2 * height_};
}

double Camera::pixels_per_metre(const Vec3& place) const {
  return is_parallel() ? focal_ : focal_ / std::abs((eye_ - place).dot(back_));
}

CameraSpec fitted_camera(std::span<const Vec3> points, double radius, const Vec3& back, const Vec3& up,
                         double aspect, const ViewMargins& margins) {
  CameraSpec spec;
  const Vec3 right = up.cross(back).normalized();
  const Vec3 upward = back.cross(right);
  const double tangent = half_tangent(spec.field_of_view);
  // Each point limits the eye's place by four planes: it has to be on the inner side of the view's edges.
  // Along the picture's width and height these are two problems of two unknowns, the eye's offset and its
  // distance.
  struct Slopes {
    double low;  // of the view's edges
    double high;
  };
  struct Offsets {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
  };
  const Slopes across{margins.side * tangent * aspect, margins.side * tangent * aspect};
  const Slopes upright{margins.bottom * tangent, margins.top * tangent};
  Offsets x;
  Offsets y;
  double nearest = -std::numeric_limits<double>::infinity();
  const auto limit = [&](Offsets& offsets, const Slopes& slopes, double across_view, double depth) {
    offsets.high =
        std::min(offsets.high, across_view - slopes.low * depth - radius * std::hypot(1, slopes.low));
    offsets.low =
        std::max(offsets.low, across_view + slopes.high * depth + radius * std::hypot(1, slopes.high));
  };
  Vec3 low = points.front();
  Vec3 high = points.front();
  for (const Vec3& point : points) {
    const double depth = point.dot(back);
    nearest = std::max(nearest, depth);
    limit(x, across, point.dot(right), depth);
    limit(y, upright, point.dot(upward), depth);
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  // offset ≤ high + slope.low · distance and offset ≥ low − slope.high · distance.
  const double distance = std::max({(x.low - x.high) / (across.low + across.high),
                                    (y.low - y.high) / (upright.low + upright.high), nearest + 4 * radius});
  const auto middle = [&](const Offsets& offsets, const Slopes& slopes) {
    return (offsets.high + slopes.low * distance + offsets.low - slopes.high * distance) / 2;
  };
  spec.eye = middle(x, across) * right + middle(y, upright) * upward + distance * back;
  // On the axis of view, at the depth of the points' middle.
  spec.target = spec.eye - back * std::max((spec.eye - (low + high) / 2).dot(back), radius);
  spec.up = up;
  return spec;
}

CameraSpec fitted_parallel_camera(std::span<const Vec3> points, double radius, const Vec3& back,
                                  const Vec3& up, double aspect, const ViewMargins& margins) {
  Eigen::Matrix3d axes;  // rows: right, up, back
  axes.row(0) = up.cross(back).normalized();
  axes.row(1) = back.cross(axes.row(0).transpose());
  axes.row(2) = back;
  Vec3 low = axes * points.front();
  Vec3 high = low;
  for (const Vec3& point : points) {
    low = low.cwiseMin(axes * point);
    high = high.cwiseMax(axes * point);
  }
  low.array() -= radius;
  high.array() += radius;
  const Vec3 extent = high - low;
  // Half of what is in view.
  const double half =
      std::max(extent.x() / (2 * margins.side * aspect), extent.y() / (margins.top + margins.bottom));
  const double middle = (high.y() - margins.top * half + low.y() + margins.bottom * half) / 2;
  CameraSpec spec;
  spec.view_height = 2 * half;
  spec.target = axes.transpose() * Vec3((low.x() + high.x()) / 2, middle, (low.z() + high.z()) / 2);
  spec.eye = spec.target + back * std::max(extent.z(), 2 * half);
  spec.up = up;
  return spec;
}

}  // namespace plumb
