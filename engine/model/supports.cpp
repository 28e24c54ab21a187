#include "engine/model/supports.h"

#include "engine/model/block_lu.h"
#include "engine/model/block_tridiagonal.h"

namespace plumb {
namespace {

/// Projection on the admissible rates of one node.
Block6 node_projection(Support support, const Vec3& direction) {
  Block6 P = Block6::Identity();
  if (support == Support::free) return P;
  P.topLeftCorner<3, 3>().setZero();
  if (support == Support::clamped) P.bottomRightCorner<3, 3>() = direction * direction.transpose();
  return P;
}

}  // namespace

SupportProjection::SupportProjection(const SupportsSpec& supports, const Vec3& direction, int nodes,
                                     CableModel model)
    : supports_(supports), direction_(direction), nodes_(nodes), slopes_held_(model == CableModel::chain) {}

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
  if (!slopes_held_) return;
  for (int node = 0; node < nodes_; ++node) x.segment<3>(6 * node + 3).setZero();
}

void SupportProjection::apply(BlockTridiagonal& A) const {
  const auto hold = [&](Support support, int node) {
    if (support == Support::free) return;
    const Block6 P = node_projection(support, direction_);
    const Block6 diagonal = A.diagonal(node).selfadjointView<Eigen::Lower>();
    A.diagonal(node) = P * diagonal * P + Block6::Identity() - P;
    if (node == 0)
      A.below(0) = (A.below(0) * P).eval();
    else
      A.below(node - 1) = (P * A.below(node - 1)).eval();
  };
  hold(supports_.first, 0);
  hold(supports_.last, nodes_ - 1);
  if (!slopes_held_) return;
  // Slopes are coupled to nothing.
  for (int node = 0; node < nodes_; ++node) A.diagonal(node).bottomRightCorner<3, 3>().setIdentity();
}

void SupportProjection::apply(GeneralBlockTridiagonal<double>& A) const {
  const auto hold = [&](Support support, int node) {
    if (support == Support::free) return;
    const Block6 P = node_projection(support, direction_);
    Block6& diagonal = A.diagonal[static_cast<std::size_t>(node)];
    diagonal = (P * diagonal * P + Block6::Identity() - P).eval();
    const std::size_t beside = static_cast<std::size_t>(node == 0 ? 0 : node - 1);
    Block6& rows = node == 0 ? A.above[beside] : A.below[beside];
    Block6& columns = node == 0 ? A.below[beside] : A.above[beside];
    rows = (P * rows).eval();
    columns = (columns * P).eval();
  };
  hold(supports_.first, 0);
  hold(supports_.last, nodes_ - 1);
  if (!slopes_held_) return;
  for (Block6& diagonal : A.diagonal) diagonal.bottomRightCorner<3, 3>().setIdentity();
}

}  // namespace plumb
