#pragma once

#include <Eigen/LU>
#include <optional>
#include <vector>

#include "engine/model/block_tridiagonal.h"

namespace plumb {

/// A block tridiagonal matrix that need not be symmetric.
struct GeneralBlockTridiagonal {
  explicit GeneralBlockTridiagonal(int nodes)
      : diagonal(static_cast<std::size_t>(nodes)),
        below(static_cast<std::size_t>(nodes - 1)),
        above(static_cast<std::size_t>(nodes - 1)) {}
  explicit GeneralBlockTridiagonal(const BlockTridiagonal& symmetric);

  int nodes() const { return static_cast<int>(diagonal.size()); }
  void set_zero();

  std::vector<Block6> diagonal;
  std::vector<Block6> below;  ///< rows of the next node
  std::vector<Block6> above;  ///< columns of the next node
};

/// LU factors of a block tridiagonal matrix with row exchanges within each block, for the matrices that are
/// not symmetric positive definite: that of a cable in strong compression, that of a discrete gradient.
class BlockLu {
 public:
  /// Factors A. Returns the first node whose pivot vanishes against its column or is not finite; nothing if
  /// all is well. After a failure the factors must not be used.
  [[nodiscard]] std::optional<int> factor(const GeneralBlockTridiagonal& A);

  /// x := A⁻¹ x.
  void solve(Eigen::VectorXd& x) const;

 private:
  std::vector<Eigen::PartialPivLU<Block6>> pivots_;  // of the eliminated diagonal blocks D
  std::vector<Block6> over_;                         // D⁻¹ · above
  std::vector<Block6> below_;
};

}  // namespace plumb
