#include "engine/base/dense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace plumb {
namespace dense_test {

Eigen::MatrixXd made(Eigen::Index size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
}

TEST(Dense, EigenvectorsOfASymmetricPencilSolveIt) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Eigen::MatrixXd X = made(1 + seed % 7, seed), A = X + X.transpose();
    const Eigen::MatrixXd B = X * X.transpose() + Eigen::MatrixXd::Identity(X.rows(), X.rows());
    const auto [values, vectors] = symmetric_eigen(A, B);
    EXPECT_LE((A * vectors - B * vectors * values.asDiagonal()).norm(), 1e-12 * A.norm()) << "seed " << seed;
    EXPECT_LE((vectors.transpose() * B * vectors - Eigen::MatrixXd::Identity(X.rows(), X.rows())).norm(),
              1e-12)
        << "seed " << seed;
    EXPECT_TRUE(std::ranges::is_sorted(values)) << values.transpose();
  }
}

TEST(Dense, WhatAPencilsRightHandSideDoesNotTellFromZeroIsLeftOut) {
  const Eigen::Matrix3d A = Eigen::Vector3d(4, 3, 2).asDiagonal();
  const auto [values, vectors] = symmetric_eigen(A, Eigen::Matrix3d(Eigen::Vector3d(1, 2, 0).asDiagonal()));
  ASSERT_EQ(values.size(), 2);
  EXPECT_DOUBLE_EQ(values[0], 1.5);
  EXPECT_DOUBLE_EQ(values[1], 4);
  EXPECT_EQ(vectors.rows(), 3);
  EXPECT_EQ(symmetric_eigen(A * NAN, A).values.size(), 0);
}

TEST(Dense, EigenvectorsOfAGeneralMatrixSolveIt) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Eigen::MatrixXd real = made(1 + seed % 7, seed);
    const Eigen::MatrixXcd A = real;
    for (const auto& [values, vectors] : {general_eigen(A), general_eigen(real)}) {
      EXPECT_LE((A * vectors - vectors * values.asDiagonal()).norm(), 1e-12 * A.norm()) << "seed " << seed;
      EXPECT_NEAR(spectral_radius(A), values.cwiseAbs().maxCoeff(), 1e-12 * A.norm()) << "seed " << seed;
    }
  }
}

TEST(Dense, WhatIsSolvedSolvesTheSystem) {
  const Eigen::MatrixXd A = made(5, 1), B = made(5, 2);
  EXPECT_LE((A * solved(A, B) - B).norm(), 1e-12 * B.norm());
}

TEST(LeastSquares, IsTheLineThroughPointsThatLieAboutIt) {
  Eigen::MatrixXd A(4, 2);
  A << 1, 0, 1, 1, 1, 2, 1, 3;
  // Off the line 2 − 3 t by what is square to 1 and to t.
  const Eigen::VectorXd off = Eigen::Vector4d(1, -1, -1, 1);
  const Eigen::VectorXd b = A * Eigen::Vector2d(2, -3) + off;
  const auto [x, rank] = least_squares(A, b);
  EXPECT_EQ(rank, 2);
  ASSERT_EQ(x.size(), 2);
  EXPECT_NEAR(x[0], 2, 1e-14);
  EXPECT_NEAR(x[1], -3, 1e-14);
  EXPECT_NEAR((A * x - b).norm(), off.norm(), 1e-14);
}

TEST(LeastSquares, ColumnsThatDependOnOneAnotherAreNotCounted) {
  Eigen::MatrixXd A(3, 3);
  A << 1, 2, 0, 2, 4, 1, 3, 6, 2;
  const Eigen::VectorXd b = Eigen::Vector3d(1, 3, 5);
  const auto [x, rank] = least_squares(A, b);
  EXPECT_EQ(rank, 2);
  EXPECT_NEAR((A * x - b).norm(), 0, 1e-14) << x.transpose();
}

}  // namespace dense_test
}  // namespace plumb
