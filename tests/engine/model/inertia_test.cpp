#include "engine/model/inertia.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "engine/base/dense.h"

namespace plumb {
namespace inertia_test {

/// Symmetric, with a diagonal that makes some eigenvalues positive and some negative, and with rows of very
/// different size, as metres beside slopes are.
BlockTridiagonal made(int nodes, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  BlockTridiagonal A(nodes);
  const auto size = [](int row) { return row % 6 < 3 ? 1e3 : 1.0; };
  for (int node = 0; node < nodes; ++node)
    for (int column = 0; column < 6; ++column)
      for (int row = 0; row < 6; ++row) {
        A.diagonal(node)(row, column) = size(row) * size(column) * unit(generator);
        if (node + 1 < nodes) A.below(node)(row, column) = size(row) * size(column) * unit(generator);
      }
  return A;
}

TEST(Inertia, IsTheNumberOfNegativeEigenvalues) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const BlockTridiagonal A = made(1 + static_cast<int>(seed % 9), seed);
    // Counted of the scaled matrix, whose eigenvalues have the same signs and are told from round-off.
    Eigen::VectorXd scale(A.dense().rows());
    for (Eigen::Index row = 0; row < scale.size(); ++row) scale[row] = row % 6 < 3 ? 1e-3 : 1;
    const Eigen::MatrixXd scaled = scale.asDiagonal() * A.dense() * scale.asDiagonal();
    const Eigen::VectorXd values = symmetric_eigen(scaled).values;
    const auto negative = static_cast<int>((values.array() < 0).count());
    EXPECT_EQ(negative_eigenvalues(A), negative) << "seed " << seed << ", " << A.nodes() << " nodes";
  }
}

TEST(Inertia, OfAPositiveDefiniteMatrixIsNone) {
  BlockTridiagonal A(5);
  for (int node = 0; node < 5; ++node) A.diagonal(node).setIdentity();
  EXPECT_EQ(negative_eigenvalues(A), 0);
  A.diagonal(3)(2, 2) = -1e-6;
  EXPECT_EQ(negative_eigenvalues(A), 1) << "however small it is";
}

TEST(Inertia, IsNotToldOfASingularMatrixOrOneThatIsNotFinite) {
  for (const double bad :
       {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    BlockTridiagonal A(4);
    for (int node = 0; node < 4; ++node) A.diagonal(node).setIdentity();
    A.diagonal(2)(4, 4) = bad;
    EXPECT_EQ(negative_eigenvalues(A), std::nullopt) << bad;
  }
}

}  // namespace inertia_test
}  // namespace plumb
