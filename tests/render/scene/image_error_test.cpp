#include "render/scene/image_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/gl/gl_context.h"
#include "tests/render/scene/swing.h"

namespace plumb {
namespace picture_gauge_test {

/// The picture of 1000 by 500 pixels is 2 m high, seen along -Z by parallel rays: 250 pixels a metre.
SceneInput input_along_z() {
  SceneInput input = swing_input();
  input.spec.size = {1000, 500};
  CameraSpec camera;
  camera.eye = {0, 0, 5};
  camera.target = {0, 0, 0};
  camera.view_height = 2;
  input.spec.camera = camera;
  return input;
}

Trajectory moved(Trajectory run, const Vec3& by) {
  for (Eigen::VectorXd& q : run.q)
    for (Eigen::Index node = 0; node < q.size(); node += 6) q.segment<3>(node) += by;
  return run;
}

TEST(ImageErrorGauge, AKnownDisplacementHasAsManyPixelsAsTheCameraGivesIt) {
  const Trajectory truth = swing();
  const ImageErrorGauge gauge(truth, input_along_z());
  for (const auto& [by, pixels] : std::vector<std::pair<Vec3, double>>{
           {{0, 0, 0}, 0}, {{0.004, 0, 0}, 1}, {{0.012, -0.016, 0}, 5}, {{0, 0, 0.3}, 0}}) {
    const std::vector<double> distances = gauge.distances(moved(truth, by));
    ASSERT_EQ(distances.size(), 51U) << "frames of 2 s at 25 a second";
    for (const double distance : distances) EXPECT_NEAR(distance, pixels, 1e-9);
  }
}

TEST(ImageErrorGauge, TheGreatestDistanceAlongTheCableCountsInItsFrame) {
  const Trajectory truth = swing();
  Trajectory drawn = truth;
  // The middle node at 0.4 s, which is frame 10.
  drawn.q[20].segment<3>(12) += Vec3(0, 0.02, 0);
  const std::vector<double> distances = ImageErrorGauge(truth, input_along_z()).distances(drawn);
  // On the way there and back too.
  for (std::size_t k = 0; k < distances.size(); ++k)
    if (k != 11) {
      EXPECT_NEAR(distances[k], k == 10 ? 5 : 0, 1e-9) << k;
    }
  EXPECT_GT(distances[11], 0);
  EXPECT_LT(distances[11], 5);
}

TEST(ImageErrorGauge, WhatIsNotInThePictureDoesNotCount) {
  const Trajectory truth = swing();
  SceneInput input = input_along_z();
  input.spec.camera->eye = {10, 0, 5};
  input.spec.camera->target = {10, 0, 0};
  EXPECT_TRUE(ImageErrorGauge(truth, input).distances(moved(truth, {0.1, 0, 0})).empty());
  // Into the picture.
  const std::vector<double> into = ImageErrorGauge(truth, input).distances(moved(truth, {10, 0, 0}));
  EXPECT_NEAR(*std::max_element(into.begin(), into.end()), 2500, 1e-6);
}

TEST(ImageErrorGauge, WhatIsOffBetweenTwoFramesOrAfterTheLastCounts) {
  SceneInput input = input_along_z();
  const Trajectory truth = swing();
  Trajectory drawn = truth;
  drawn.q[51].tail<6>()[1] += 0.02;  // 1.02 s, between frames 25 and 26
  EXPECT_NEAR(ImageErrorGauge(truth, input).distances(drawn)[26], 5, 1e-9);
  // A motion that is over before the second frame.
  input.spec.frame_rate = 0.3;
  drawn = truth;
  drawn.q.back().tail<6>()[1] += 0.02;
  const std::vector<double> distances = ImageErrorGauge(truth, input).distances(drawn);
  ASSERT_EQ(distances.size(), 2U);
  EXPECT_EQ(distances[0], 0);
  EXPECT_NEAR(distances[1], 5, 1e-9);
}

TEST(ImageErrorGauge, WhatComesBackBetweenTwoFramesCountsWhicheverOfTheTwoMoves) {
  SceneInput input = input_along_z();
  input.spec.frame_rate = 12.5;  // 4 outputs a frame
  Trajectory truth = swing();
  for (Eigen::VectorXd& q : truth.q) q = truth.q.front();
  for (Eigen::VectorXd& v : truth.v) v.setZero();
  const auto middle = 6 * (truth.elements / 2);
  Trajectory moves = truth;
  moves.q[41][middle + 1] += 0.04;  // from 0.80 to 0.88 s, and back
  for (const auto& [one, other] : {std::pair{&truth, &moves}, std::pair{&moves, &truth}}) {
    const std::vector<double> distances = ImageErrorGauge(*one, input).distances(*other);
    EXPECT_NEAR(distances[11], 10, 1e-9);
    EXPECT_NEAR(distances[10], 0, 1e-9);
  }
}

TEST(ImageErrorGauge, ARunThatEndsEarlyOrCannotBeDrawnIsInfinitelyFarOff) {
  const Trajectory truth = swing();
  const ImageErrorGauge gauge(truth, input_along_z());
  const std::vector<double> distances = gauge.distances(swing(51));
  EXPECT_EQ(distances[25], 0);
  EXPECT_TRUE(std::isinf(distances[26]));
  Trajectory broken = truth;
  broken.q[3][7] = NAN;
  for (const double distance : gauge.distances(broken)) EXPECT_TRUE(std::isinf(distance));
}

TEST(ImageErrorGauge, MeshesAreComparedAtEqualArcLength) {
  const Trajectory truth = swing();
  // A straight cable of one and of three elements is the same line.
  const auto straight = [&](int elements) {
    Trajectory run = truth;
    run.elements = elements;
    run.element_length = 1.0 / elements;
    for (std::size_t k = 0; k < run.q.size(); ++k) {
      run.q[k].resize(6 * (elements + 1));
      for (int node = 0; node <= elements; ++node)
        run.q[k].segment<6>(6 * node) << node * run.element_length, 0, 0, 1, 0, 0;
      run.v[k].setZero(6 * (elements + 1));
    }
    return run;
  };
  const Trajectory one = straight(1);
  for (const double distance : ImageErrorGauge(one, input_along_z()).distances(straight(3)))
    EXPECT_NEAR(distance, 0, 1e-9);
}

TEST(SceneCamera, IsTheOneThatTheSceneIsDrawnThrough) {
  const GlContext context;
  const Trajectory run = swing();
  SceneInput input = swing_input();
  input.spec.size = {480, 270};
  for (const View view : {View::fit, View::front, View::top, View::orbit, View::follow}) {
    input.spec.view = view;
    const SceneRenderer scene(context, run, input);
    const SceneCamera camera(run, input);
    const std::vector<double> times = camera.frame_times();
    ASSERT_EQ(static_cast<int>(times.size()), scene.frame_count());
    for (const int k : {0, 17, 50}) {
      EXPECT_EQ(times[static_cast<std::size_t>(k)], scene.frame_time(k));
      const Vec3 place(0.3, -0.2, 0.1);
      EXPECT_LT(
          (scene.pixel(place, scene.frame_time(k)) - camera.at(scene.frame_time(k)).pixel(place)).norm(),
          1e-9)
          << static_cast<int>(view) << " frame " << k;
    }
  }
}

}  // namespace picture_gauge_test
}  // namespace plumb
