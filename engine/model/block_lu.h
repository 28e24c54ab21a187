#pragma once

#include <Eigen/LU>
#include <optional>
#include <vector>

#include "engine/model/block_tridiagonal.h"

namespace plumb {

/// What an element gives to a matrix: the rows and columns of its two nodes.
using Block12 = Eigen::Matrix<double, 12, 12>;

/// A block tridiagonal matrix that need not be symmetric, of real or complex numbers.
template <class Scalar>
struct GeneralBlockTridiagonal {
  using Block = Eigen::Matrix<Scalar, 6, 6>;

  /// All zeros.
  explicit GeneralBlockTridiagonal(int nodes)
      : diagonal(static_cast<std::size_t>(nodes), Block::Zero()),
        below(static_cast<std::size_t>(nodes - 1), Block::Zero()),
        above(static_cast<std::size_t>(nodes - 1), Block::Zero()) {}
  explicit GeneralBlockTridiagonal(const BlockTridiagonal& symmetric)
      : GeneralBlockTridiagonal(symmetric.nodes()) {
    set(symmetric);
  }

  int nodes() const { return static_cast<int>(diagonal.size()); }
  /// Becomes that matrix, with the same number of nodes.
  void set(const BlockTridiagonal& symmetric);
  /// Becomes A + factor B; all have the same number of nodes.
  void set_sum(const BlockTridiagonal& A, Scalar factor, const BlockTridiagonal& B);
  /// Becomes itself + factor B.
  void add(Scalar factor, const GeneralBlockTridiagonal<double>& B);
  /// Adds what an element gives.
  void add_element(int element, const Block12& K);
  /// y := A x.
  void multiply(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x,
                Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& y) const;

  std::vector<Block> diagonal;
  std::vector<Block> below;  ///< rows of the next node
  std::vector<Block> above;  ///< columns of the next node
};

/// A := A + B with its 3 by 3 blocks b replaced by left · b · right.
void add_turned(const GeneralBlockTridiagonal<double>& B, const Eigen::Matrix3d& left,
                const Eigen::Matrix3d& right, GeneralBlockTridiagonal<double>& A);

/// LU factors of a block tridiagonal matrix with row exchanges within each block, for the matrices that are
/// not symmetric positive definite: that of a cable in strong compression, that of a discrete gradient, the
/// complex one of a Gauss method.
template <class Scalar>
class BlockLu {
 public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /// Factors A, with rows and columns of slopes scaled to those of positions, so that neither the choice of
  /// pivots nor what is judged to vanish depends on the unit of length. Returns the first node whose pivot
  /// vanishes against its column or is not finite; nothing if all is well. After a failure the factors must
  /// not be used.
  [[nodiscard]] std::optional<int> factor(const GeneralBlockTridiagonal<Scalar>& A);

  /// x := A⁻¹ x.
  void solve(Vector& x) const;

 private:
  using Block = Eigen::Matrix<Scalar, 6, 6>;

  double slope_scale_ = 1;                          // of rows and columns
  std::vector<Eigen::PartialPivLU<Block>> pivots_;  // of the eliminated diagonal blocks D
  std::vector<Block> over_;                         // D⁻¹ · above
  std::vector<Block> below_;
};

}  // namespace plumb
