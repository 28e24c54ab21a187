#include "engine/study/economy/economy_scenes.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/base/random_draw.h"

namespace plumb {
namespace {

struct Shape {
  int width;
  int height;
};

/// Somewhere around the middle of the cable's place at the start, looking at some place of it.
std::string placed_camera(RandomDraw& draw, double length) {
  const double azimuth = draw.uniform(-3.14, 3.14), elevation = draw.uniform(-0.3, 1.2);
  const double distance = length * draw.of_equal_ratio(0.8, 4);
  const std::array<double, 3> target{length * draw.uniform(-0.8, 0.8), length * draw.uniform(-0.8, 0.1),
                                     length * draw.uniform(-0.8, 0.8)};
  const std::array<double, 3> eye{target[0] + distance * std::cos(elevation) * std::cos(azimuth),
                                  target[1] + distance * std::sin(elevation),
                                  target[2] + distance * std::cos(elevation) * std::sin(azimuth)};
  return fmt::format("scene.camera={{eye=[{:.4g},{:.4g},{:.4g}],target=[{:.4g},{:.4g},{:.4g}],up=[0,1,0]}}",
                     eye[0], eye[1], eye[2], target[0], target[1], target[2]);
}

}  // namespace

std::vector<std::string> scene_overrides(const Case& file_case, long seed, long number) {
  constexpr std::array cameras{"fit", "front", "right", "top", "orbit", "follow", "placed", "placed"};
  constexpr std::array shapes{Shape{16, 9}, Shape{4, 3}, Shape{1, 1}};
  constexpr std::array rates{10, 25, 50};
  RandomDraw draw(RandomDraw::Of::scene, seed, number);
  std::vector<std::string> result;
  const double f = draw.of_equal_ratio(1, 20);
  if (file_case.parameters.contains("f")) result.push_back(fmt::format("parameters.f={:.4g}", f));
  const double turn = draw.uniform(0, 6), tilt = draw.uniform(-0.5, 0.5), side = draw.uniform(-0.5, 0.5);
  result.push_back(
      fmt::format("start.angular_velocity=[{:.4g},{:.4g},{:.4g}]", turn * side, turn, turn * tilt));
  const int rate = draw.one_of(rates);
  result.push_back(fmt::format("time.output_interval={:.4g}", 1.0 / rate));
  result.push_back(fmt::format("time.end={:.4g}", draw.uniform(0.2, 1)));
  result.push_back(fmt::format("scene.frame_rate={}", rate));
  const double width = std::round(draw.of_equal_ratio(160, 1920));
  const Shape shape = draw.one_of(shapes);
  result.push_back(
      fmt::format("scene.size=[{:.0f},{:.0f}]", width, std::round(width * shape.height / shape.width)));
  const std::string camera = draw.one_of(cameras);
  result.push_back(camera == "placed" ? placed_camera(draw, file_case.cable.length)
                                      : "scene.camera=" + camera);
  result.push_back(fmt::format("scene.tolerance={:.3g}", draw.of_equal_ratio(0.25, 4)));
  return result;
}

}  // namespace plumb
