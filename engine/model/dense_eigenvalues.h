#pragma once

#include <Eigen/Core>

/// Eigen's eigenvalue solvers of small dense matrices, instantiated once for all who ask.
namespace plumb {

/// Eigenvalues, and eigenvectors as columns in the same order.
struct Eigenvectors3 {
  Eigen::Vector3cd values;
  Eigen::Matrix3cd columns;
};
Eigenvectors3 eigenvectors(const Eigen::Matrix3d& A);

/// The largest modulus of the eigenvalues.
double spectral_radius(const Eigen::Matrix3d& A);
double spectral_radius(const Eigen::MatrixXcd& A);

}  // namespace plumb
