#include "render/scene/trail.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {

namespace {

// The ribbon at one place.
struct Section {
  std::array<Eigen::Vector4d, 2> edges;  // clip coordinates
  double opacity = 0;
  bool visible = false;
};

}  // namespace

std::vector<float> trail_ribbon(std::span<const Vec3> places, const Camera& camera, double width,
                                int picture_width, int picture_height) {
  std::vector<Section> sections(places.size());
  const auto count = places.size();
  Point direction = Point::UnitX();
  for (std::size_t i = 0; i < count; ++i) {
    const Point way =
        camera.pixel(places[std::min(i + 1, count - 1)]) - camera.pixel(places[i == 0 ? 0 : i - 1]);
    if (way.norm() > 1e-6)
      direction = way.normalized();  // where the tip rests, or nothing is seen: as before
    const double youth = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 1;
    const double half = width * (0.35 + 0.65 * youth) / 2;
    const Eigen::Vector4d clip = camera.matrix() * places[i].homogeneous();
    const Eigen::Vector4d side =
        half * clip.w() *
        Eigen::Vector4d(-direction.y() * 2 / picture_width, -direction.x() * 2 / picture_height, 0, 0);
    sections[i] = {{clip - side, clip + side}, std::pow(youth, 1.3), camera.pixel(places[i]).allFinite()};
  }

  std::vector<float> triangles;
  const auto append = [&](const Section& section, std::size_t edge) {
    for (int c = 0; c < 4; ++c) triangles.push_back(static_cast<float>(section.edges[edge][c]));
    triangles.push_back(static_cast<float>(section.opacity));
  };
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Section& a = sections[i];
    const Section& b = sections[i + 1];
    if (!a.visible || !b.visible) continue;
    append(a, 0);
    append(a, 1);
    append(b, 0);
    append(b, 0);
    append(a, 1);
    append(b, 1);
  }
  return triangles;
}

}  // namespace plumb
