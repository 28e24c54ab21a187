#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/kernels/kernels.h"

namespace plumb {

/// Where strain energy is integrated in an element: r' and r'' there are sums over its nodal vectors (r₀,
/// r'₀, r₁, r'₁).
struct IntegrationPoint {
  double weight;                ///< times the element's length, m
  std::array<double, 4> slope;  ///< 1/m and 1
  std::array<double, 4> bend;   ///< 1/m² and 1/m
};

/// Those of stretching and of bending, in each element.
std::vector<IntegrationPoint> stretching_points(const ElementConstants& element);
std::vector<IntegrationPoint> bending_points(const ElementConstants& element);

/// The sum over the nodal vectors of an element, whose 12 coordinates begin at q.
inline Eigen::Vector3d combine(const std::array<double, 4>& shape, const double* q) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) sum += shape[i] * Eigen::Map<const Eigen::Vector3d>(q + 3 * i);
  return sum;
}

}  // namespace plumb
