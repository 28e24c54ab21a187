#include "render/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "engine/base/errors.h"
#include "engine/model/cable.h"
#include "engine/model/hermite.h"
#include "render/image/apng.h"
#include "tests/render/image/pictures.h"
#include "tests/render/scene/swing.h"

namespace plumb {
namespace scene_test {

std::array<int, 3> at(const Image& image, const Point& place) {
  const int x = static_cast<int>(place.x());
  const int y = static_cast<int>(place.y());
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return {-1, -1, -1};
  const auto i = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

// Cable pixels have the cable's hue, dark or lit.
bool is_cable(const std::array<int, 3>& color) {
  return color[2] > color[0] + 40 && color[0] >= 0;
}

Vec3 on_cable(const Eigen::VectorXd& q, int element, double x) {
  const auto s = Hermite::values(x, 0.25);
  return s[0] * q.segment<3>(6 * element) + s[1] * q.segment<3>(6 * element + 3) +
         s[2] * q.segment<3>(6 * element + 6) + s[3] * q.segment<3>(6 * element + 9);
}

SceneInput small_input() {
  SceneInput input = swing_input();
  input.spec.size = {320, 240};
  return input;
}

class SceneTest : public testing::Test {
 protected:
  GlContext context_;
  Trajectory trajectory_ = swing();
};

TEST_F(SceneTest, TwoSecondsAt25FramesASecondAre51Frames) {
  SceneRenderer scene(context_, trajectory_, swing_input());
  ASSERT_EQ(scene.frame_count(), 51);
  EXPECT_DOUBLE_EQ(scene.frame_time(50), 2.0);
  for (const int k : {0, 8, 20, 35, 50}) keep("frame_" + std::to_string(k), scene.frame(k));
}

TEST_F(SceneTest, FramesStopAtTheLastOutput) {
  SceneInput input = small_input();
  input.spec.frame_rate = 30;
  const Trajectory half = swing(27);  // to 0.52 s
  const SceneRenderer scene(context_, half, input);
  EXPECT_EQ(scene.frame_count(), 16);
  EXPECT_LE(scene.frame_time(15), 0.52);
}

TEST_F(SceneTest, CableIsSeenAlongItsCurveAndNotAlongItsChords) {
  Trajectory bent = swing(1);
  // Slopes turned to either side by 60°, so that each element bows out by a twentieth of a metre.
  for (int node = 0; node <= 4; ++node) {
    bent.q[0].segment<3>(6 * node) = Vec3(0.25 * node, 0, 0);
    bent.q[0].segment<3>(6 * node + 3) = Vec3(0.5, node % 2 == 0 ? 0.87 : -0.87, 0);
  }
  SceneRenderer scene(context_, bent, swing_input());
  const Image image = scene.frame(0);
  keep("frame_bent", image);
  for (int e = 0; e < 4; ++e)
    for (const double x : {0.3, 0.5, 0.7}) {
      const Point curve = scene.pixel(on_cable(bent.q[0], e, x));
      EXPECT_TRUE(is_cable(at(image, curve)))
          << "element " << e << ", x = " << x << ", pixel " << curve.transpose();
    }
  const Point chord = scene.pixel(Vec3(0.375, 0, 0));
  EXPECT_FALSE(is_cable(at(image, chord))) << "pixel " << chord.transpose();
}

TEST_F(SceneTest, CableIsWhereTheStateBetweenTwoOutputsPutsIt) {
  // Every fourth output: between them, straight lines in time would miss by far more than the cable's radius.
  Trajectory coarse = trajectory_;
  coarse.times.clear();
  coarse.q.clear();
  coarse.v.clear();
  for (std::size_t i = 0; i < trajectory_.times.size(); i += 4) {
    coarse.times.push_back(trajectory_.times[i]);
    coarse.q.push_back(trajectory_.q[i]);
    coarse.v.push_back(trajectory_.v[i]);
  }
  SceneRenderer scene(context_, coarse, swing_input());
  for (const std::size_t i : {22UL, 66UL}) {
    const Image image = scene.at(trajectory_.times[i]);
    for (const double x : {0.2, 0.5, 0.8}) {
      const Point place = scene.pixel(on_cable(trajectory_.q[i], 2, x));
      EXPECT_TRUE(is_cable(at(image, place)))
          << "t = " << trajectory_.times[i] << ", pixel " << place.transpose();
    }
  }
}

TEST_F(SceneTest, DefaultCameraSeesTheWholeMotion) {
  for (const std::array<int, 2> size : {std::array{960, 540}, std::array{300, 600}}) {
    SceneInput input = swing_input();
    input.spec.size = size;
    const SceneRenderer scene(context_, trajectory_, input);
    for (const Eigen::VectorXd& q : trajectory_.q)
      for (int node = 0; node <= 4; ++node) {
        const Point p = scene.pixel(q.segment<3>(6 * node));
        EXPECT_TRUE(p.x() > 0 && p.y() > 0 && p.x() < size[0] && p.y() < size[1])
            << "node " << node << " at pixel " << p.transpose();
      }
  }
}

TEST_F(SceneTest, GivenCameraLooksAtItsTarget) {
  SceneInput input = small_input();
  input.spec.camera = CameraSpec{{0, 0.5, 4}, {0.2, -0.1, 0}, {0, 1, 0}, 40, 0};
  const SceneRenderer scene(context_, trajectory_, input);
  const Point middle = scene.pixel({0.2, -0.1, 0});
  EXPECT_NEAR(middle.x(), 160, 1e-6);
  EXPECT_NEAR(middle.y(), 120, 1e-6);
  EXPECT_LT(scene.pixel({0.2, 0.1, 0}).y(), middle.y()) << "up is not up in the picture";
  EXPECT_FALSE(scene.pixel({0, 0.5, 5}).allFinite()) << "a place behind the camera has a pixel";
}

TEST_F(SceneTest, SameInputGivesTheSamePixels) {
  SceneRenderer scene(context_, trajectory_, small_input());
  const Image first = scene.frame(20);
  scene.frame(3);
  EXPECT_EQ(scene.frame(20), first) << "after another frame";
  EXPECT_EQ(SceneRenderer(context_, trajectory_, small_input()).frame(20), first) << "by another renderer";
  Image elsewhere;
  std::thread([&] {
    const GlContext context;
    elsewhere = SceneRenderer(context, trajectory_, small_input()).frame(20);
  }).join();
  EXPECT_EQ(elsewhere, first) << "in another thread and context";
}

TEST_F(SceneTest, FramesDiffer) {
  SceneRenderer scene(context_, trajectory_, small_input());
  EXPECT_NE(scene.frame(1), scene.frame(2));
}

TEST_F(SceneTest, SupportsAreDrawnAsSuch) {
  std::vector<Image> images;
  for (const Support support : {Support::free, Support::pinned, Support::clamped}) {
    SceneInput input = small_input();
    input.supports.first = support;
    images.push_back(SceneRenderer(context_, trajectory_, input).frame(10));
  }
  EXPECT_NE(images[0], images[1]);
  EXPECT_NE(images[0], images[2]);
  EXPECT_NE(images[1], images[2]);
}

TEST_F(SceneTest, RunThatEndedAtItsFirstOutputHasOneFrame) {
  const Trajectory one = swing(1);
  SceneRenderer scene(context_, one, small_input());
  EXPECT_EQ(scene.frame_count(), 1);
  EXPECT_EQ(scene.frame(0).width, 320);
}

TEST_F(SceneTest, CableThatIsSeenEndOnIsDrawn) {
  SceneInput input = small_input();
  input.gravity = Vec3::Zero();
  input.spec.camera = CameraSpec{{4, 0, 0}, {0, 0, 0}, {0, 1, 0}, 20};
  const Trajectory one = swing(1);
  SceneRenderer scene(context_, one, input);
  EXPECT_TRUE(is_cable(at(scene.frame(0), scene.pixel(on_cable(one.q[0], 3, 1)))));
}

TEST_F(SceneTest, CameraWithinTheMotionDraws) {
  SceneInput input = small_input();
  input.spec.camera = CameraSpec{{0.3, -0.1, 0.05}, {0, -0.2, 0}, {0, 1, 0}, 90};
  SceneRenderer scene(context_, trajectory_, input);
  for (int k = 0; k < scene.frame_count(); k += 10) EXPECT_NO_THROW(scene.frame(k));
}

TEST_F(SceneTest, HangingStillCableHasAView) {
  Trajectory still = swing(1);
  for (int node = 0; node <= 4; ++node) still.q[0].segment<6>(6 * node) << 0, -0.25 * node, 0, 0, -1, 0;
  SceneRenderer scene(context_, still, swing_input());
  const Image image = scene.frame(0);
  keep("frame_hanging", image);
  EXPECT_TRUE(is_cable(at(image, scene.pixel({0, -0.5, 0}))));
}

TEST_F(SceneTest, StatesThatAreNotFiniteAreRefused) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e9}) {
    Trajectory broken = trajectory_;
    broken.q[70][12] = bad;
    EXPECT_THROW(SceneRenderer(context_, broken, small_input()), OutputError) << bad;
  }
  Trajectory broken = trajectory_;
  broken.v[70][12] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(SceneRenderer(context_, broken, small_input()), OutputError);
}

TEST_F(SceneTest, RunWithoutOutputsOrWithStatesOfTheWrongSizeIsRefused) {
  EXPECT_THROW(SceneRenderer(context_, Trajectory{}, small_input()), OutputError);
  Trajectory broken = trajectory_;
  broken.q[3].conservativeResize(24);
  EXPECT_THROW(SceneRenderer(context_, broken, small_input()), OutputError);
  broken = trajectory_;
  broken.v.pop_back();
  EXPECT_THROW(SceneRenderer(context_, broken, small_input()), OutputError);
}

TEST_F(SceneTest, CameraWithoutAViewIsRefused) {
  SceneInput input = small_input();
  input.spec.camera = CameraSpec{{1, 1, 1}, {1, 1, 1}, {0, 1, 0}, 35};
  EXPECT_THROW(SceneRenderer(context_, trajectory_, input), OutputError);
  input.spec.camera = CameraSpec{{0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 35};
  EXPECT_THROW(SceneRenderer(context_, trajectory_, input), OutputError);
}

TEST(SceneInput, OfACaseHasTheRadiusOfTheCircularSection) {
  Case pendulum;
  pendulum.cable.length = 1;
  pendulum.cable.area = 2.5e-5;
  pendulum.title = "Pendulum";
  const SceneInput input = scene_input(pendulum);
  EXPECT_NEAR(input.radius, 2.8209e-3, 1e-7);
  EXPECT_EQ(input.title, "Pendulum");
}

}  // namespace scene_test
}  // namespace plumb
