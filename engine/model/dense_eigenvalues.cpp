#include "engine/model/dense_eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace plumb {

Eigenvectors3 eigenvectors(const Eigen::Matrix3d& A) {
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

double spectral_radius(const Eigen::Matrix3d& A) {
  return Eigen::EigenSolver<Eigen::Matrix3d>(A, false).eigenvalues().cwiseAbs().maxCoeff();
}

double spectral_radius(const Eigen::MatrixXcd& A) {
  return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(A, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace plumb
