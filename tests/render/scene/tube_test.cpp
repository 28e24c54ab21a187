#include "render/scene/tube.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace plumb {
namespace tube_test {

std::vector<CurvePoint> helix(int pieces) {
  std::vector<CurvePoint> curve;
  for (int i = 0; i <= pieces; ++i) {
    const double s = 6.0 * i / pieces;
    curve.push_back({{std::cos(s), 0.3 * s, std::sin(s)}, Vec3(-std::sin(s), 0.3, std::cos(s)).normalized()});
  }
  return curve;
}

Vec3 vector_at(const TubeMesh& mesh, std::size_t vertex, std::size_t offset) {
  const float* v = &mesh.vertices[6 * vertex + offset];
  return {v[0], v[1], v[2]};
}

TEST(Tube, EveryVertexIsOneRadiusFromTheCurveAlongItsNormal) {
  const std::vector<CurvePoint> curve = helix(100);
  const TubeMesh mesh = tube_mesh(curve, 0.05, 12);
  for (std::size_t i = 0; i < mesh.vertices.size() / 6; ++i) {
    const Vec3 normal = vector_at(mesh, i, 3);
    EXPECT_NEAR(normal.norm(), 1, 1e-6);
    const Vec3 center = vector_at(mesh, i, 0) - 0.05 * normal;
    double distance = 1;
    for (const CurvePoint& point : curve) distance = std::min(distance, (center - point.position).norm());
    EXPECT_LT(distance, 1e-6) << "vertex " << i;
  }
}

TEST(Tube, RingsFollowEachOtherWithoutTwist) {
  const int sides = 12;
  const TubeMesh mesh = tube_mesh(helix(100), 0.05, sides);
  const std::size_t rings = mesh.vertices.size() / 6 / sides;
  for (std::size_t r = 1; r < rings; ++r) {
    const double cosine = vector_at(mesh, sides * r, 3).dot(vector_at(mesh, sides * (r - 1), 3));
    // The caps' rings lean by 30° from one to the next, the curve's by some degrees.
    EXPECT_GT(cosine, 0.85) << "ring " << r << " of " << rings;
  }
}

TEST(Tube, SurfaceIsClosedButForItsPoles) {
  const TubeMesh mesh = tube_mesh(helix(20), 0.05, 8);
  std::map<std::pair<unsigned, unsigned>, int> edges;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned a = mesh.indices[t + k];
      const unsigned b = mesh.indices[t + (k + 1) % 3];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  int open = 0;
  for (const auto& [edge, count] : edges) {
    if (count == 2) continue;
    ++open;
    const double length = (vector_at(mesh, edge.first, 0) - vector_at(mesh, edge.second, 0)).norm();
    EXPECT_LT(length, 1e-6) << "an open edge between vertices " << edge.first << " and " << edge.second;
  }
  EXPECT_EQ(open, 16) << "8 at each pole";
}

TEST(Tube, CurveThatTurnsBackOnItselfHasFiniteVertices) {
  const std::vector<CurvePoint> curve = {
      {{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {-1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}};
  for (const float value : tube_mesh(curve, 0.1, 8).vertices) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace tube_test
}  // namespace plumb
