#include "engine/model/block_tridiagonal.h"

#include <gtest/gtest.h>

#include <random>

namespace plumb {
namespace {

BlockTridiagonal random_matrix(int nodes, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  BlockTridiagonal A(nodes);
  for (int i = 0; i < nodes; ++i) {
    const BlockTridiagonal::Block block =
        BlockTridiagonal::Block::NullaryExpr([&] { return unit(generator); });
    A.diagonal(i) = block + block.transpose();
    if (i + 1 < nodes) A.upper(i) = BlockTridiagonal::Block::NullaryExpr([&] { return unit(generator); });
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

TEST(BlockTridiagonal, LuSolvesIndefiniteSystems) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const int nodes = 2 + static_cast<int>(seed % 9);
    const BlockTridiagonal A = random_matrix(nodes, seed);
    const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(6 * nodes, -1, 1);
    Eigen::VectorXd x;
    A.multiply(expected, x);
    BlockTridiagonalLu lu(nodes);
    ASSERT_EQ(lu.factor(A), std::nullopt) << "seed " << seed;
    lu.solve(x);
    EXPECT_LE((x - expected).norm(), 1e-8 * expected.norm()) << "seed " << seed;
  }
}

TEST(BlockTridiagonal, LuNamesTheNodeOfASingularBlock) {
  BlockTridiagonal A = random_matrix(5, 3);
  BlockTridiagonalLu lu(5);
  A.upper(2).setZero();
  A.upper(3).setZero();
  A.diagonal(3).col(4).setZero();
  A.diagonal(3).row(4).setZero();
  EXPECT_EQ(lu.factor(A), 3);
}

TEST(BlockTridiagonal, LuNamesTheNodeOfANumberThatIsNotFinite) {
  BlockTridiagonal A = random_matrix(5, 4);
  BlockTridiagonalLu lu(5);
  A.diagonal(2)(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(lu.factor(A), 2);
}

}  // namespace
}  // namespace plumb
