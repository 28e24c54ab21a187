#include "engine/model/block_lu.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace plumb {
namespace {

/// A pivot smaller than this against the largest number of its column is round-off of a zero.
constexpr double singular_ratio = 1e-14;

Block6 full_diagonal(const BlockTridiagonal& symmetric, int node) {
  return symmetric.diagonal(node).selfadjointView<Eigen::Lower>();
}

/// A power of two by which rows and columns of slopes become about as large as those of positions.
template <class Scalar>
double slope_scale(const GeneralBlockTridiagonal<Scalar>& A) {
  double positions = 0, slopes = 0;
  for (const auto& block : A.diagonal) {
    positions = std::max<double>(positions, block.diagonal().template head<3>().cwiseAbs().maxCoeff());
    slopes = std::max<double>(slopes, block.diagonal().template tail<3>().cwiseAbs().maxCoeff());
  }
  const double ratio = std::sqrt(positions / slopes);
  return std::isnormal(ratio) ? std::exp2(std::ilogb(ratio)) : 1;
}

template <class Block>
void scale_slopes(double scale, Block& block) {
  block.template rightCols<3>() *= scale;
  block.template bottomRows<3>() *= scale;
}

}  // namespace

template <class Scalar>
void GeneralBlockTridiagonal<Scalar>::set(const BlockTridiagonal& symmetric) {
  for (int i = 0; i < nodes(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    diagonal[at] = full_diagonal(symmetric, i).template cast<Scalar>();
    if (i + 1 == nodes()) break;
    below[at] = symmetric.below(i).template cast<Scalar>();
    above[at] = below[at].transpose();
  }
}

template <class Scalar>
void GeneralBlockTridiagonal<Scalar>::set_sum(const BlockTridiagonal& A, Scalar factor,
                                              const BlockTridiagonal& B) {
  for (int i = 0; i < nodes(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    diagonal[at] =
        full_diagonal(A, i).template cast<Scalar>() + factor * full_diagonal(B, i).template cast<Scalar>();
    if (i + 1 == nodes()) break;
    below[at] = A.below(i).template cast<Scalar>() + factor * B.below(i).template cast<Scalar>();
    above[at] = below[at].transpose();
  }
}

template <class Scalar>
void GeneralBlockTridiagonal<Scalar>::add(Scalar factor, const GeneralBlockTridiagonal<double>& B) {
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    diagonal[i] += factor * B.diagonal[i].template cast<Scalar>();
    if (i + 1 == diagonal.size()) break;
    below[i] += factor * B.below[i].template cast<Scalar>();
    above[i] += factor * B.above[i].template cast<Scalar>();
  }
}

void add_turned(const GeneralBlockTridiagonal<double>& B, const Eigen::Matrix3d& left,
                const Eigen::Matrix3d& right, GeneralBlockTridiagonal<double>& A) {
  const auto add = [&](const std::vector<Block6>& from, std::vector<Block6>& to) {
    for (std::size_t node = 0; node < from.size(); ++node)
      for (int i = 0; i < 6; i += 3)
        for (int j = 0; j < 6; j += 3)
          to[node].block<3, 3>(i, j) += left * from[node].block<3, 3>(i, j) * right;
  };
  add(B.diagonal, A.diagonal);
  add(B.below, A.below);
  add(B.above, A.above);
}

template <class Scalar>
void GeneralBlockTridiagonal<Scalar>::add_element(int element, const Block12& K) {
  const auto at = static_cast<std::size_t>(element);
  diagonal[at] += K.topLeftCorner<6, 6>().cast<Scalar>();
  above[at] += K.topRightCorner<6, 6>().cast<Scalar>();
  below[at] += K.bottomLeftCorner<6, 6>().cast<Scalar>();
  diagonal[at + 1] += K.bottomRightCorner<6, 6>().cast<Scalar>();
}

template <class Scalar>
void GeneralBlockTridiagonal<Scalar>::multiply(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x,
                                               Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& y) const {
  y.setZero(x.size());
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const auto at = 6 * static_cast<Eigen::Index>(i);
    y.template segment<6>(at) += diagonal[i] * x.template segment<6>(at);
    if (i + 1 == diagonal.size()) break;
    y.template segment<6>(at) += above[i] * x.template segment<6>(at + 6);
    y.template segment<6>(at + 6) += below[i] * x.template segment<6>(at);
  }
}

template <class Scalar>
std::optional<int> BlockLu<Scalar>::factor(const GeneralBlockTridiagonal<Scalar>& A) {
  const auto nodes = static_cast<std::size_t>(A.nodes());
  pivots_.resize(nodes);
  over_.resize(nodes - 1);
  below_ = A.below;
  slope_scale_ = slope_scale(A);
  for (Block& block : below_) scale_slopes(slope_scale_, block);
  Block eliminated, above;
  for (std::size_t i = 0; i < nodes; ++i) {
    eliminated = A.diagonal[i];
    scale_slopes(slope_scale_, eliminated);
    const Eigen::Matrix<double, 1, 6> largest = eliminated.cwiseAbs().colwise().maxCoeff();
    if (i > 0) eliminated.noalias() -= below_[i - 1] * over_[i - 1];
    pivots_[i].compute(eliminated);
    const auto pivots = pivots_[i].matrixLU().diagonal();
    for (int k = 0; k < 6; ++k) {
      const double pivot = std::abs(pivots[k]);
      if (!std::isfinite(pivot) || !(pivot > singular_ratio * largest[k])) return static_cast<int>(i);
    }
    if (i + 1 == nodes) break;
    above = A.above[i];
    scale_slopes(slope_scale_, above);
    over_[i] = pivots_[i].solve(above);
  }
  return std::nullopt;
}

template <class Scalar>
void BlockLu<Scalar>::solve(Vector& x) const {
  using Segment = Eigen::Matrix<Scalar, 6, 1>;
  const std::size_t nodes = pivots_.size();
  const auto part = [&](std::size_t i) { return x.template segment<6>(6 * static_cast<Eigen::Index>(i)); };
  for (std::size_t i = 0; i < nodes; ++i) {
    part(i).template tail<3>() *= slope_scale_;
    if (i > 0) part(i).noalias() -= below_[i - 1] * Segment(part(i - 1));
    part(i) = pivots_[i].solve(Segment(part(i)));
  }
  for (std::size_t i = nodes - 1; i-- > 0;) part(i).noalias() -= over_[i] * Segment(part(i + 1));
  for (std::size_t i = 0; i < nodes; ++i) part(i).template tail<3>() *= slope_scale_;
}

template struct GeneralBlockTridiagonal<double>;
template struct GeneralBlockTridiagonal<std::complex<double>>;
template class BlockLu<double>;
template class BlockLu<std::complex<double>>;

}  // namespace plumb
