#include "engine/model/block_lu.h"

#include <cmath>

namespace plumb {
namespace {

/// A pivot smaller than this against the largest number of its column is round-off of a zero.
constexpr double singular_ratio = 1e-14;

using Segment = Eigen::Matrix<double, 6, 1>;

}  // namespace

GeneralBlockTridiagonal::GeneralBlockTridiagonal(const BlockTridiagonal& symmetric)
    : GeneralBlockTridiagonal(symmetric.nodes()) {
  for (int i = 0; i < nodes(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    diagonal[at] = symmetric.diagonal(i).selfadjointView<Eigen::Lower>();
    if (i + 1 == nodes()) break;
    below[at] = symmetric.below(i);
    above[at] = symmetric.below(i).transpose();
  }
}

void GeneralBlockTridiagonal::set_zero() {
  for (auto* blocks : {&diagonal, &below, &above})
    for (Block6& block : *blocks) block.setZero();
}

std::optional<int> BlockLu::factor(const GeneralBlockTridiagonal& A) {
  const auto nodes = static_cast<std::size_t>(A.nodes());
  pivots_.resize(nodes);
  over_.resize(nodes - 1);
  below_ = A.below;
  Block6 eliminated;
  for (std::size_t i = 0; i < nodes; ++i) {
    eliminated = A.diagonal[i];
    if (i > 0) eliminated.noalias() -= below_[i - 1] * over_[i - 1];
    pivots_[i].compute(eliminated);
    const auto pivots = pivots_[i].matrixLU().diagonal();
    for (int k = 0; k < 6; ++k) {
      const double largest = A.diagonal[i].col(k).cwiseAbs().maxCoeff();
      if (!std::isfinite(pivots[k]) || !(std::abs(pivots[k]) > singular_ratio * largest))
        return static_cast<int>(i);
    }
    if (i + 1 < nodes) over_[i] = pivots_[i].solve(A.above[i]);
  }
  return std::nullopt;
}

void BlockLu::solve(Eigen::VectorXd& x) const {
  const std::size_t nodes = pivots_.size();
  const auto part = [&](std::size_t i) { return x.segment<6>(6 * static_cast<Eigen::Index>(i)); };
  for (std::size_t i = 0; i < nodes; ++i) {
    if (i > 0) part(i).noalias() -= below_[i - 1] * Segment(part(i - 1));
    part(i) = pivots_[i].solve(Segment(part(i)));
  }
  for (std::size_t i = nodes - 1; i-- > 0;) part(i).noalias() -= over_[i] * Segment(part(i + 1));
}

}  // namespace plumb
