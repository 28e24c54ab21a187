#pragma once

#include <Eigen/Core>

namespace plumb {

/// The x with the least |A x − b|.
struct LeastSquares {
  Eigen::VectorXd x;  ///< one number a column of A
  Eigen::Index rank;  ///< of A, by its pivots; below its number of columns, x is one of many
};

/// Solution by Householder's reflections with exchange of columns, for an A with no fewer rows than columns
/// and finite numbers: Eigen's, compiled once for all who ask.
LeastSquares least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace plumb
