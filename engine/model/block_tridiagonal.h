#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <optional>
#include <vector>

namespace plumb {

/// A symmetric matrix with 6 by 6 blocks on the diagonal and beside it: the shape that a chain of two-node
/// elements gives. Memory and every operation are linear in the number of nodes.
class BlockTridiagonal {
 public:
  using Block = Eigen::Matrix<double, 6, 6>;

  explicit BlockTridiagonal(int nodes);

  int nodes() const { return static_cast<int>(diagonal_.size()); }
  void set_zero();
  /// A := factor · A.
  void scale(double factor);
  /// y := A x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  /// The same matrix in full, for tests and small eigenproblems.
  Eigen::MatrixXd dense() const;

  Block& diagonal(int node) { return diagonal_[static_cast<std::size_t>(node)]; }
  const Block& diagonal(int node) const { return diagonal_[static_cast<std::size_t>(node)]; }
  /// Block of rows `node` and columns `node` + 1; the one below the diagonal is its transpose.
  Block& upper(int node) { return upper_[static_cast<std::size_t>(node)]; }
  const Block& upper(int node) const { return upper_[static_cast<std::size_t>(node)]; }

 private:
  std::vector<Block> diagonal_;
  std::vector<Block> upper_;
};

/// LU factors of a BlockTridiagonal with row exchanges within each block, so that an indefinite tangent (a
/// cable in compression) is no trouble unless it is singular.
class BlockTridiagonalLu {
 public:
  explicit BlockTridiagonalLu(int nodes);

  /// Factors A. Returns the first node whose pivot vanishes against its column or is not finite; nothing if
  /// all is well. After a failure the factors must not be used.
  [[nodiscard]] std::optional<int> factor(const BlockTridiagonal& A);

  /// x := A⁻¹ x.
  void solve(Eigen::VectorXd& x) const;

 private:
  using Block = BlockTridiagonal::Block;

  std::vector<Eigen::PartialPivLU<Block>> pivots_;  // of the eliminated diagonal blocks D
  std::vector<Block> over_;                         // D⁻¹ · upper
};

}  // namespace plumb
