#include "render/scene/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

namespace plumb {
namespace camera_test {

std::vector<Vec3> some_places() {
  return {{0, 0, 0}, {1, 0.2, -0.3}, {-0.4, -0.9, 0.8}, {0.3, 0.5, 0.1}};
}

TEST(Camera, ParallelRaysShowAMetreAlikeEverywhere) {
  CameraSpec spec{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}};
  spec.view_height = 2;
  const Camera camera(spec, 400, 300, {0, 0, 0}, 3);
  EXPECT_TRUE(camera.is_parallel());
  for (const double depth : {-2.0, 0.0, 2.5}) {
    EXPECT_DOUBLE_EQ(camera.pixels_per_metre({0.1, 0.2, depth}), 150);
    const Point p = camera.pixel({0.5, 0.25, depth});
    EXPECT_NEAR(p.x(), 200 + 0.5 * 150, 1e-9);
    EXPECT_NEAR(p.y(), 150 - 0.25 * 150, 1e-9);
  }
}

TEST(Camera, ParallelDepthGrowsAwayFromTheEyeWithinItsRange) {
  CameraSpec spec{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}};
  spec.view_height = 2;
  const Camera camera(spec, 400, 300, {0, 0, 1}, 3);
  const auto depth = [&](double z) { return (camera.matrix() * Vec3(0, 0, z).homogeneous()).z(); };
  EXPECT_NEAR(depth(4), -1, 1e-12);
  EXPECT_NEAR(depth(-2), 1, 1e-12);
  EXPECT_LT(depth(1), depth(0));
}

TEST(Camera, FittedParallelViewHoldsAllPointsAndNoMoreThanItMust) {
  const std::vector<Vec3> places = some_places();
  const ViewMargins margins;
  const double radius = 0.02;
  for (const double aspect : {0.5, 1.0, 2.0}) {
    const double width = 600 * aspect;
    const CameraSpec spec =
        fitted_parallel_camera(places, radius, Vec3(1, 1, 2).normalized(), {0, 1, 0}, aspect, margins);
    const Camera camera(spec, static_cast<int>(width), 600, {0, 0, 0}, 3);
    const double ball = radius * camera.pixels_per_metre({0, 0, 0});
    double left = width, right = 0, top = 600, bottom = 0;
    for (const Vec3& place : places) {
      const Point p = camera.pixel(place);
      left = std::min(left, p.x() - ball);
      right = std::max(right, p.x() + ball);
      top = std::min(top, p.y() - ball);
      bottom = std::max(bottom, p.y() + ball);
    }
    const double side = (1 - margins.side) * width / 2, above = (1 - margins.top) * 300,
                 below = (1 - margins.bottom) * 300;
    EXPECT_GE(left, side - 1e-6);
    EXPECT_LE(right, width - side + 1e-6);
    EXPECT_GE(top, above - 1e-6);
    EXPECT_LE(bottom, 600 - below + 1e-6);
    const bool full = std::abs(right - left - margins.side * width) < 1e-6 ||
                      std::abs(bottom - top - (margins.top + margins.bottom) * 300) < 1e-6;
    EXPECT_TRUE(full) << "could be nearer at aspect " << aspect;
  }
}

TEST(Camera, FittedParallelViewOfAPointHasAHeight) {
  const CameraSpec spec =
      fitted_parallel_camera(std::vector<Vec3>{{1, 2, 3}}, 0.1, {0, 0, 1}, {0, 1, 0}, 1.5, {});
  EXPECT_GT(spec.view_height, 0.2);
  const Point p = Camera(spec, 300, 200, {1, 2, 3}, 1).pixel({1, 2, 3});
  EXPECT_NEAR(p.x(), 150, 1e-9);
}

}  // namespace camera_test
}  // namespace plumb
