#pragma once

#include <Eigen/Core>

namespace plumb {

/// [a]×, with [a]× b = a × b.
inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  return Eigen::Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
}

}  // namespace plumb
