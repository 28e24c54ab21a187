#pragma once

#include <Eigen/Core>

/// Eigen's decompositions of dense matrices, each compiled once for all who ask. Entries are finite unless
/// something else is said.
namespace plumb {

/// Eigenvalues of a symmetric matrix, rising, and eigenvectors as columns in the same order.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// Of A x = value x; orthonormal vectors. Only what is on the diagonal of A and below it is read.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

/// Of A x = value B x with a B that is positive semidefinite; vectors with xᵀ B x = 1. Directions that B does
/// not tell from 0 are left out, so that there may be fewer of them; none where a number is not finite.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// Eigenvalues of any square matrix, and eigenvectors as columns in the same order.
struct GeneralEigen {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
GeneralEigen general_eigen(const Eigen::MatrixXcd& A);
/// The same, in which complex ones are pairs of conjugates.
GeneralEigen general_eigen(const Eigen::MatrixXd& A);

/// The largest modulus of the eigenvalues of A.
double spectral_radius(const Eigen::MatrixXcd& A);

/// A⁻¹ B, of an A that is not singular.
Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// The x with the least |A x − b|.
struct LeastSquares {
  Eigen::VectorXd x;  ///< one number a column of A
  Eigen::Index rank;  ///< of A, by its pivots; below its number of columns, x is one of many
};

/// Solution by Householder's reflections with exchange of columns, for an A with no fewer rows than columns.
LeastSquares least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace plumb
