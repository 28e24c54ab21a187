#include "render/scene/tube.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace plumb {

namespace {

Vec3 across(const Vec3& tangent) {
  return tangent.unitOrthogonal();
}

// Carried from one tangent to the next by removing what has come to point along it.
Vec3 carried(const Vec3& normal, const Vec3& tangent) {
  const Vec3 rest = normal - normal.dot(tangent) * tangent;
  return rest.norm() > 1e-6 ? rest.normalized() : across(tangent);
}

}  // namespace

TubeMesh tube_mesh(std::span<const CurvePoint> curve, double radius, int sides,
                   std::span<const float> levels) {
  TubeMesh mesh;
  int rings = 0;
  // The normals of a ring lean by `lean` from straight outwards towards the tangent.
  const auto ring = [&](std::size_t i, const Vec3& normal, double lean) {
    const CurvePoint& point = curve[i];
    const Vec3 other = point.tangent.cross(normal);
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      const Vec3 outward = std::cos(lean) * (std::cos(angle) * normal + std::sin(angle) * other) +
                           std::sin(lean) * point.tangent;
      const Vec3 place = point.position + radius * outward;
      for (const Vec3& vector : {place, outward})
        for (int c = 0; c < 3; ++c) mesh.vertices.push_back(static_cast<float>(vector[c]));
      if (!levels.empty()) mesh.vertices.push_back(levels[i]);
    }
    ++rings;
  };

  const int cap_rings = std::max(2, sides / 4);
  const auto lean = [&](int i) { return std::numbers::pi / 2 * i / cap_rings; };
  Vec3 normal = across(curve.front().tangent);
  for (int i = cap_rings; i > 0; --i) ring(0, normal, -lean(i));
  for (std::size_t i = 0; i < curve.size(); ++i) {
    normal = carried(normal, curve[i].tangent);
    ring(i, normal, 0);
  }
  for (int i = 1; i <= cap_rings; ++i) ring(curve.size() - 1, normal, lean(i));

  for (int i = 0; i + 1 < rings; ++i)
    for (int k = 0; k < sides; ++k) {
      const auto at = [&](int r, int s) { return static_cast<unsigned>(r * sides + s % sides); };
      for (const unsigned index :
           {at(i, k), at(i, k + 1), at(i + 1, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)})
        mesh.indices.push_back(index);
    }
  return mesh;
}

}  // namespace plumb
