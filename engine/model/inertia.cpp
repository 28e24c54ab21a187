#include "engine/model/inertia.h"

#include "engine/base/dense.h"

namespace plumb {

std::optional<int> negative_eigenvalues(const BlockTridiagonal& A) {
  // A smaller one is round-off of a zero.
  constexpr double singular_ratio = 1e-14;
  int negative = 0;
  Block6 taken = Block6::Zero();  // off the diagonal block by the node before
  for (int node = 0; node < A.nodes(); ++node) {
    Block6 left = A.diagonal(node).selfadjointView<Eigen::Lower>();
    left -= taken;
    // Metres stand beside slopes: a congruence that makes the diagonal 1 keeps the signs and tells more of
    // them from round-off.
    Eigen::Matrix<double, 6, 1> scale = left.diagonal().cwiseAbs().cwiseSqrt();
    for (double& one : scale)
      if (!(one > 0)) one = 1;
    const auto inverse_scale = scale.cwiseInverse().asDiagonal();
    const Block6 scaled = inverse_scale * left * inverse_scale;
    if (!scaled.allFinite()) return std::nullopt;
    const auto& [values, vectors] = symmetric_eigen(scaled);
    if (!(values.cwiseAbs().minCoeff() > singular_ratio * values.cwiseAbs().maxCoeff())) return std::nullopt;
    negative += static_cast<int>((values.array() < 0).count());
    if (node + 1 == A.nodes()) break;
    const Block6 turned = A.below(node) * inverse_scale * vectors;
    taken = turned * values.cwiseInverse().asDiagonal() * turned.transpose();
  }
  return negative;
}

}  // namespace plumb
