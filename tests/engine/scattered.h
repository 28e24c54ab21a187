#pragma once

#include <Eigen/Core>
#include <cmath>

namespace plumb {

/// Numbers of no order between -1 and 1, the same for each seed.
inline Eigen::VectorXd scattered(Eigen::Index size, double seed) {
  Eigen::VectorXd x(size);
  for (Eigen::Index i = 0; i < size; ++i) x[i] = std::sin(12.9898 * static_cast<double>(i + 1) + seed);
  return x;
}

}  // namespace plumb
