#include "engine/model/supports.h"

#include <gtest/gtest.h>

#include "engine/model/block_tridiagonal.h"
#include "tests/engine/model/dense_matrix.h"

namespace plumb {
namespace supports_test {

/// A symmetric matrix of random numbers; of the diagonal blocks the rows above the diagonal hold no numbers,
/// as nobody may read them.
BlockTridiagonal random_matrix(int nodes) {
  std::srand(7);
  BlockTridiagonal A(nodes);
  for (int node = 0; node < nodes; ++node) {
    A.diagonal(node) = Block6::Random();
    A.diagonal(node).triangularView<Eigen::StrictlyUpper>().setConstant(
        std::numeric_limits<double>::quiet_NaN());
    if (node + 1 < nodes) A.below(node) = Block6::Random();
  }
  return A;
}

TEST(SupportProjection, OfAMatrixIsPAPAndTheIdentityWhereItHolds) {
  const Vec3 direction = Vec3(1, 2, -2) / 3;
  for (const Support first : {Support::free, Support::pinned, Support::clamped})
    for (const Support last : {Support::free, Support::pinned, Support::clamped})
      for (const int nodes : {2, 3, 4}) {
        const SupportProjection supports({first, last}, direction, nodes);
        Eigen::MatrixXd P(6 * nodes, 6 * nodes);
        for (int j = 0; j < 6 * nodes; ++j) {
          Eigen::VectorXd unit = Eigen::VectorXd::Unit(6 * nodes, j);
          supports.apply(unit);
          P.col(j) = unit;
        }
        EXPECT_LE((P * P - P).norm(), 1e-15);
        BlockTridiagonal A = random_matrix(nodes);
        const Eigen::MatrixXd expected =
            P * A.dense() * P + Eigen::MatrixXd::Identity(6 * nodes, 6 * nodes) - P;
        GeneralBlockTridiagonal<double> general(A);
        supports.apply(general);
        supports.apply(A);
        EXPECT_LE((A.dense() - expected).norm(), 1e-14)
            << word(first) << ", " << word(last) << ", " << nodes << " nodes";
        EXPECT_LE((dense(general) - expected).norm(), 1e-14)
            << word(first) << ", " << word(last) << ", " << nodes << " nodes, general";
      }
}

}  // namespace supports_test
}  // namespace plumb
