#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/kernels/kernels.h"

namespace plumb {

using Block6 = Eigen::Matrix<double, 6, 6>;

/// A symmetric matrix with 6 by 6 blocks on the diagonal and beside it: the shape that a chain of two-node
/// elements gives. It is held as the block columns of kernels.h; of the diagonal blocks only the lower
/// triangle is meaningful. Memory and every operation are linear in the number of nodes.
class BlockTridiagonal {
 public:
  using Map = Eigen::Map<Block6, 0, Eigen::OuterStride<12>>;
  using ConstMap = Eigen::Map<const Block6, 0, Eigen::OuterStride<12>>;

  /// All zeros.
  explicit BlockTridiagonal(int nodes)
      : columns_(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(block_column_size), 0.0) {}

  int nodes() const { return static_cast<int>(columns_.size()) / block_column_size; }

  /// Diagonal block of a node; its lower triangle counts.
  Map diagonal(int node) { return Map(columns_.data() + block_column_size * node); }
  ConstMap diagonal(int node) const { return ConstMap(columns_.data() + block_column_size * node); }
  /// Block of rows `node` + 1 and columns `node`; the one above the diagonal is its transpose.
  Map below(int node) { return Map(columns_.data() + block_column_size * node + 6); }
  ConstMap below(int node) const { return ConstMap(columns_.data() + block_column_size * node + 6); }

  double* data() { return columns_.data(); }
  const double* data() const { return columns_.data(); }

  /// y := A x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  /// The same matrix in full, for tests and small eigenproblems.
  Eigen::MatrixXd dense() const;

 private:
  std::vector<double> columns_;
};

}  // namespace plumb
