#include "engine/base/dense.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace plumb {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  constexpr double round_off = 1e-15;  // of the greatest
  if (!A.allFinite() || !B.allFinite()) return {};
  const auto [sizes, axes] = symmetric_eigen(B);
  const Eigen::Index kept = (sizes.array() > round_off * sizes.cwiseAbs().maxCoeff()).count();
  const Eigen::MatrixXd scaled =
      axes.rightCols(kept) * sizes.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  SymmetricEigen result = symmetric_eigen(scaled.transpose() * A.selfadjointView<Eigen::Lower>() * scaled);
  result.vectors = scaled * result.vectors;
  return result;
}

GeneralEigen general_eigen(const Eigen::MatrixXcd& A) {
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

GeneralEigen general_eigen(const Eigen::MatrixXd& A) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

double spectral_radius(const Eigen::MatrixXcd& A) {
  return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(A, false).eigenvalues().cwiseAbs().maxCoeff();
}

Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return Eigen::PartialPivLU<Eigen::MatrixXd>(A).solve(B);
}

LeastSquares least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(A);
  return {factors.solve(b), factors.rank()};
}

}  // namespace plumb
