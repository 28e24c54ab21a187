#include "engine/model/supports.h"

#include "engine/model/block_tridiagonal.h"

namespace plumb {
namespace {

/// Projection on the admissible rates of one node.
BlockTridiagonal::Block node_projection(Support support, const Vec3& direction) {
  BlockTridiagonal::Block P = BlockTridiagonal::Block::Identity();
  if (support == Support::free) return P;
  P.topLeftCorner<3, 3>().setZero();
  if (support == Support::clamped) P.bottomRightCorner<3, 3>() = direction * direction.transpose();
  return P;
}

}  // namespace

SupportProjection::SupportProjection(const SupportsSpec& supports, const Vec3& direction, int nodes)
    : supports_(supports), direction_(direction), nodes_(nodes) {}

void SupportProjection::apply(Eigen::VectorXd& x) const {
  const auto hold = [&](Support support, int node) {
    if (support == Support::free) return;
    x.segment<3>(6 * node).setZero();
    if (support == Support::clamped) {
      auto slope = x.segment<3>(6 * node + 3);
      slope = direction_ * direction_.dot(slope);
    }
  };
  hold(supports_.first, 0);
  hold(supports_.last, nodes_ - 1);
}

void SupportProjection::apply(BlockTridiagonal& A) const {
  const auto hold = [&](Support support, int node) {
    if (support == Support::free) return;
    const BlockTridiagonal::Block P = node_projection(support, direction_);
    A.diagonal(node) = (P * A.diagonal(node) * P + BlockTridiagonal::Block::Identity() - P).eval();
    if (node == 0)
      A.upper(0) = (P * A.upper(0)).eval();
    else
      A.upper(node - 1) = (A.upper(node - 1) * P).eval();
  };
  hold(supports_.first, 0);
  hold(supports_.last, nodes_ - 1);
}

}  // namespace plumb
