#include "engine/base/least_squares.h"

#include <gtest/gtest.h>

namespace plumb {
namespace least_squares_test {

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

}  // namespace least_squares_test
}  // namespace plumb
