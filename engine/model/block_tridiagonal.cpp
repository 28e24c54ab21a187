#include "engine/model/block_tridiagonal.h"

#include <cmath>

namespace plumb {
namespace {

/// A pivot smaller than this against the largest number of its column is round-off of a zero.
constexpr double singular_ratio = 1e-14;

using Segment = Eigen::Matrix<double, 6, 1>;

}  // namespace

BlockTridiagonal::BlockTridiagonal(int nodes)
    : diagonal_(static_cast<std::size_t>(nodes)), upper_(static_cast<std::size_t>(nodes - 1)) {
  set_zero();
}

void BlockTridiagonal::set_zero() {
  for (Block& block : diagonal_) block.setZero();
  for (Block& block : upper_) block.setZero();
}

void BlockTridiagonal::scale(double factor) {
  for (Block& block : diagonal_) block *= factor;
  for (Block& block : upper_) block *= factor;
}

void BlockTridiagonal::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  const int count = nodes();
  y.resize(6 * count);
  for (int i = 0; i < count; ++i) {
    Segment sum = diagonal(i) * x.segment<6>(6 * i);
    if (i > 0) sum += upper(i - 1).transpose() * x.segment<6>(6 * (i - 1));
    if (i + 1 < count) sum += upper(i) * x.segment<6>(6 * (i + 1));
    y.segment<6>(6 * i) = sum;
  }
}

Eigen::MatrixXd BlockTridiagonal::dense() const {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(6 * nodes(), 6 * nodes());
  for (int i = 0; i < nodes(); ++i) {
    full.block<6, 6>(6 * i, 6 * i) = diagonal(i);
    if (i + 1 == nodes()) break;
    full.block<6, 6>(6 * i, 6 * i + 6) = upper(i);
    full.block<6, 6>(6 * i + 6, 6 * i) = upper(i).transpose();
  }
  return full;
}

BlockTridiagonalLu::BlockTridiagonalLu(int nodes)
    : pivots_(static_cast<std::size_t>(nodes)), over_(static_cast<std::size_t>(nodes - 1)) {}

std::optional<int> BlockTridiagonalLu::factor(const BlockTridiagonal& A) {
  Block eliminated;
  for (int i = 0; i < A.nodes(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    eliminated = A.diagonal(i);
    if (i > 0) eliminated.noalias() -= A.upper(i - 1).transpose() * over_[at - 1];
    pivots_[at].compute(eliminated);
    const auto pivots = pivots_[at].matrixLU().diagonal();
    for (int k = 0; k < 6; ++k) {
      const double largest = A.diagonal(i).col(k).cwiseAbs().maxCoeff();
      if (!std::isfinite(pivots[k]) || !(std::abs(pivots[k]) > singular_ratio * largest)) return i;
    }
    if (i + 1 < A.nodes()) over_[at] = pivots_[at].solve(A.upper(i));
  }
  return std::nullopt;
}

void BlockTridiagonalLu::solve(Eigen::VectorXd& x) const {
  const auto count = static_cast<int>(pivots_.size());
  // Forward: y_i = b_i − U_{i−1}ᵀ D_{i−1}⁻¹ y_{i−1} = b_i − over_{i−1}ᵀ y_{i−1}, as the eliminated D are
  // symmetric.
  for (int i = 1; i < count; ++i)
    x.segment<6>(6 * i).noalias() -=
        over_[static_cast<std::size_t>(i - 1)].transpose() * x.segment<6>(6 * (i - 1));
  for (int i = count - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    Segment part = pivots_[at].solve(Segment(x.segment<6>(6 * i)));
    if (i + 1 < count) part.noalias() -= over_[at] * x.segment<6>(6 * (i + 1));
    x.segment<6>(6 * i) = part;
  }
}

}  // namespace plumb
