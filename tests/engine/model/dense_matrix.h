#pragma once

#include <Eigen/Core>

#include "engine/model/block_lu.h"

namespace plumb {

/// A block tridiagonal matrix in full.
template <class Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> dense(const GeneralBlockTridiagonal<Scalar>& A) {
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> full;
  full.setZero(6 * A.nodes(), 6 * A.nodes());
  for (int i = 0; i < A.nodes(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    full.template block<6, 6>(6 * i, 6 * i) = A.diagonal[at];
    if (i + 1 == A.nodes()) break;
    full.template block<6, 6>(6 * i + 6, 6 * i) = A.below[at];
    full.template block<6, 6>(6 * i, 6 * i + 6) = A.above[at];
  }
  return full;
}

}  // namespace plumb
