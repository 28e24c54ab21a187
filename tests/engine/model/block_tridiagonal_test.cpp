#include "engine/model/block_tridiagonal.h"

#include <gtest/gtest.h>

#include <random>

namespace plumb {
namespace block_tridiagonal_test {

BlockTridiagonal random_matrix(int nodes, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  BlockTridiagonal A(nodes);
  for (int i = 0; i < nodes; ++i) {
    A.diagonal(i) = Block6::NullaryExpr([&] { return unit(generator); });
    if (i + 1 < nodes) A.below(i) = Block6::NullaryExpr([&] { return unit(generator); });
  }
  return A;
}

TEST(BlockTridiagonal, MultipliesAsTheFullMatrixDoes) {
  const BlockTridiagonal A = random_matrix(7, 1);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(42, -1, 2);
  Eigen::VectorXd y;
  A.multiply(x, y);
  EXPECT_LE((y - A.dense() * x).norm(), 1e-13);
}

}  // namespace block_tridiagonal_test
}  // namespace plumb
