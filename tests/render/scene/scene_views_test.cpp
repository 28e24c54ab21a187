#include <gtest/gtest.h>

#include "engine/case/case_words.h"
#include "tests/render/image/pictures.h"
#include "tests/render/scene/swing.h"

namespace plumb {
namespace scene_views_test {

SceneInput view_input(View view, std::array<int, 2> size = {320, 240}) {
  SceneInput input = swing_input();
  input.spec.size = size;
  input.spec.view = view;
  return input;
}

class SceneViews : public testing::Test {
 protected:
  Point pixel(View view, const Vec3& place, double time = 0) const {
    return SceneRenderer(context_, trajectory_, view_input(view)).pixel(place, time);
  }

  GlContext context_;
  Trajectory trajectory_ = swing();
};

TEST_F(SceneViews, AllSeeTheWholeMotionAndAllButFollowThroughout) {
  for (const auto& [view, written] : words_of<View>)
    for (const std::array<int, 2> size : {std::array{960, 540}, std::array{300, 600}}) {
      SceneInput input = view_input(view, size);
      input.spec.color_by = ColorField::none;
      SceneRenderer scene(context_, trajectory_, input);
      for (std::size_t i = 0; i < trajectory_.times.size(); i += 5)
        for (int node = 0; node <= 4; ++node)
          for (const double other : {0.0, 0.4, 1.1}) {
            const double time = view == View::follow ? trajectory_.times[i] : trajectory_.times[i] + other;
            const Point p = scene.pixel(trajectory_.q[i].segment<3>(6 * node), std::min(time, 2.0));
            EXPECT_TRUE(p.x() > 0 && p.y() > 0 && p.x() < size[0] && p.y() < size[1])
                << written << ": node " << node << " at " << p.transpose();
          }
      for (const int k : {0, 20})
        keep(std::string("view_") + std::string(written) + "_" + std::to_string(size[0]) + "_" +
                 std::to_string(k),
             scene.frame(k));
    }
}

TEST_F(SceneViews, AlongAxesHaveTheirAxesRightAndUp) {
  struct Sides {
    View view;
    Vec3 right, up, back;
  };
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  for (const Sides& sides :
       {Sides{View::front, x, y, z}, Sides{View::back, -x, y, -z}, Sides{View::left, z, y, -x},
        Sides{View::right, -z, y, x}, Sides{View::top, x, -z, y}, Sides{View::bottom, x, z, -y}}) {
    const Point middle = pixel(sides.view, Vec3::Zero());
    const Point right = pixel(sides.view, 0.1 * sides.right) - middle;
    const Point up = pixel(sides.view, 0.1 * sides.up) - middle;
    EXPECT_GT(right.x(), 1) << static_cast<int>(sides.view);
    EXPECT_NEAR(right.y(), 0, 1e-9);
    EXPECT_LT(up.y(), -1);
    EXPECT_NEAR(up.x(), 0, 1e-9);
    EXPECT_NEAR((pixel(sides.view, 0.1 * sides.back) - middle).norm(), 0, 1e-9);
  }
}

TEST_F(SceneViews, OrbitTurnsOnceAroundTheMotion) {
  SceneRenderer scene(context_, trajectory_, view_input(View::orbit));
  const Vec3 tip = trajectory_.q[0].segment<3>(24);
  EXPECT_NEAR((scene.pixel(tip, 0) - scene.pixel(tip, 2)).norm(), 0, 1e-6);
  EXPECT_GT((scene.pixel(tip, 0) - scene.pixel(tip, 1)).norm(), 50) << "not turned by half";
  EXPECT_NE(scene.frame(0), scene.frame(50));
}

TEST_F(SceneViews, OrbitDrawsItsBackdropAnew) {
  Trajectory still = trajectory_;
  for (std::size_t i = 0; i < still.q.size(); ++i) {
    still.q[i] = still.q[0];
    still.v[i].setZero();
  }
  SceneInput input = view_input(View::orbit);
  input.spec.trail = 0;
  SceneRenderer scene(context_, still, input);
  const Image first = scene.frame(0);
  scene.frame(25);
  EXPECT_EQ(scene.frame(0), first) << "something of another frame is left";
}

TEST_F(SceneViews, FollowKeepsTheCableInTheMiddle) {
  SceneRenderer scene(context_, trajectory_, view_input(View::follow));
  for (std::size_t i = 0; i < trajectory_.times.size(); i += 10) {
    // Its mean place, to the trapezoidal rule over its nodes.
    Vec3 middle = Vec3::Zero();
    for (int node = 0; node <= 4; ++node)
      middle += (node % 4 == 0 ? 0.125 : 0.25) * trajectory_.q[i].segment<3>(6 * node);
    const Point p = scene.pixel(middle, trajectory_.times[i]);
    EXPECT_NEAR(p.x(), 160, 4) << trajectory_.times[i];
    EXPECT_NEAR(p.y(), 120, 4) << trajectory_.times[i];
  }
}

TEST_F(SceneViews, GroundSeenEdgeOnIsALine) {
  SceneRenderer scene(context_, trajectory_, view_input(View::front));
  const Image image = scene.frame(10);
  // The ground's line is the lowest dark row at the left edge, where no cable comes.
  int rows = 0;
  for (int y = 121; y < 240; ++y) {
    const auto at = [&](int row) { return image.rgb[static_cast<std::size_t>(3 * row * image.width)]; };
    rows += at(y) + 8 < at(y - 1) ? 1 : 0;
  }
  EXPECT_EQ(rows, 1);
}

TEST_F(SceneViews, GivenParallelCameraIsTaken) {
  SceneInput input = view_input(View::orbit);
  input.spec.camera = CameraSpec{{0.2, -0.1, 4}, {0.2, -0.1, 0}, {0, 1, 0}};
  input.spec.camera->view_height = 2.4;
  const SceneRenderer scene(context_, trajectory_, input);
  for (const double time : {0.0, 0.7}) {
    EXPECT_NEAR(scene.pixel({0.2, -0.1, 0}, time).x(), 160, 1e-9) << "a given camera does not move";
    EXPECT_NEAR((scene.pixel({0.2, 0.9, 0}, time) - scene.pixel({0.2, -0.1, 0}, time)).norm(), 100, 1e-9);
  }
}

TEST_F(SceneViews, OfARunOfOneOutputDraw) {
  const Trajectory one = swing(1);
  for (const auto& [view, written] : words_of<View>) {
    SceneRenderer scene(context_, one, view_input(view));
    EXPECT_EQ(scene.frame(0).width, 320) << written;
  }
}

}  // namespace scene_views_test
}  // namespace plumb
