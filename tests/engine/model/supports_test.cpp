#include "engine/model/supports.h"

#include <fmt/format.h>
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

/// That `held` is P A P and, of what each support holds, a positive multiple of the identity.
void expect_projected(const Eigen::MatrixXd& P, const Eigen::MatrixXd& A, const Eigen::MatrixXd& held,
                      const std::string& where) {
  EXPECT_LE((P * held - P * A * P).norm(), 1e-14) << where;
  const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(A.rows(), A.cols()) - P;
  for (const auto& direction : rest.colwise()) {
    if (direction.norm() < 1e-3) continue;
    const Eigen::VectorXd result = held * direction;
    const double size = direction.dot(result) / direction.squaredNorm();
    EXPECT_GT(size, 0) << where;
    EXPECT_LE((result - size * direction).norm(), 1e-14) << where;
  }
}

TEST(SupportProjection, OfAMatrixIsPAPAndAMultipleOfTheIdentityWhereItHolds) {
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
        const Eigen::MatrixXd whole = A.dense();
        GeneralBlockTridiagonal<double> general(A);
        supports.apply(general);
        supports.apply(A);
        const std::string where = fmt::format("{}, {}, {} nodes", word(first), word(last), nodes);
        expect_projected(P, whole, A.dense(), where);
        expect_projected(P, whole, dense(general), where + ", general");
      }
}

}  // namespace supports_test
}  // namespace plumb
