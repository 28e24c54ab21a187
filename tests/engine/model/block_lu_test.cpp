#include "engine/model/block_lu.h"

#include <gtest/gtest.h>

#include <complex>
#include <limits>
#include <random>

#include "tests/engine/model/dense_matrix.h"

namespace plumb {
namespace block_lu_test {

GeneralBlockTridiagonal<double> random_matrix(int nodes, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  GeneralBlockTridiagonal<double> A(nodes);
  for (auto* blocks : {&A.diagonal, &A.below, &A.above})
    for (Block6& block : *blocks) block = Block6::NullaryExpr([&] { return unit(generator); });
  return A;
}

TEST(BlockLu, SolvesSystemsThatAreNeitherSymmetricNorDefinite) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const int nodes = 2 + static_cast<int>(seed % 9);
    const GeneralBlockTridiagonal<double> A = random_matrix(nodes, seed);
    const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(6 * nodes, -1, 1);
    Eigen::VectorXd x = dense(A) * expected;
    BlockLu<double> lu;
    ASSERT_EQ(lu.factor(A), std::nullopt) << "seed " << seed;
    lu.solve(x);
    EXPECT_LE((x - expected).norm(), 1e-8 * expected.norm()) << "seed " << seed;
  }
}

// What the Gauss method solves: M + λ K with a complex λ, from two symmetric matrices.
TEST(BlockLu, SolvesTheComplexSumOfTwoSymmetricMatrices) {
  using Complex = std::complex<double>;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const int nodes = 2 + static_cast<int>(seed % 5);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    BlockTridiagonal A(nodes), B(nodes);
    for (BlockTridiagonal* matrix : {&A, &B})
      for (int i = 0; i < nodes; ++i) {
        matrix->diagonal(i) = Block6::NullaryExpr([&] { return unit(generator); });
        if (i + 1 < nodes) matrix->below(i) = Block6::NullaryExpr([&] { return unit(generator); });
      }
    const Complex factor(0.3, -0.7);
    GeneralBlockTridiagonal<Complex> sum(nodes);
    sum.set_sum(A, factor, B);
    const Eigen::MatrixXcd full = A.dense().cast<Complex>() + factor * B.dense().cast<Complex>();
    const Eigen::VectorXcd expected =
        Eigen::VectorXcd::NullaryExpr(6 * nodes, [&] { return Complex(unit(generator), unit(generator)); });
    Eigen::VectorXcd x = full * expected;
    BlockLu<Complex> lu;
    ASSERT_EQ(lu.factor(sum), std::nullopt) << "seed " << seed;
    lu.solve(x);
    EXPECT_LE((x - expected).norm(), 1e-8 * expected.norm()) << "seed " << seed;
  }
}

TEST(BlockLu, NamesTheNodeOfASingularBlock) {
  GeneralBlockTridiagonal<double> A = random_matrix(5, 3);
  BlockLu<double> lu;
  A.below[2].setZero();
  A.above[3].setZero();
  A.above[2].setZero();
  A.diagonal[3].col(4).setZero();
  EXPECT_EQ(lu.factor(A), 3);
}

TEST(BlockLu, NamesTheNodeOfANumberThatIsNotFinite) {
  GeneralBlockTridiagonal<double> A = random_matrix(5, 4);
  BlockLu<double> lu;
  A.diagonal[2](1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(lu.factor(A), 2);
}

}  // namespace block_lu_test
}  // namespace plumb
