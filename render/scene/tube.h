#pragma once

#include <span>
#include <vector>

#include "render/scene/motion.h"

namespace plumb {

/// A closed surface of triangles.
struct TubeMesh {
  std::vector<float>
      vertices;  ///< position (m), unit normal and level, if any: six or seven numbers a vertex
  std::vector<unsigned> indices;  ///< three a triangle
};

/// A tube of a radius (m) around a curve of at least one point, with `sides` ≥ 3 and round ends. Its frame is
/// carried along the curve without twist. A curve of one point gives a ball. `levels`: one a point, which its
/// vertices then have, or none.
TubeMesh tube_mesh(std::span<const CurvePoint> curve, double radius, int sides,
                   std::span<const float> levels = {});

}  // namespace plumb
