#include "engine/model/mode_shapes.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace plumb {

Eigen::MatrixXd starting_modes(int nodes, Eigen::Index wished) {
  Eigen::MatrixXd X(6 * nodes, std::min<Eigen::Index>(wished, nodes));
  for (Eigen::Index k = 0; k < X.cols(); ++k)
    for (Eigen::Index i = 0; i < X.rows(); ++i)
      X(i, k) = std::cos(static_cast<double>((k + 1) * (i / 6)) / nodes + 1.3 * static_cast<double>(k) +
                         2.1 * static_cast<double>(i % 6));
  return X;
}

template <class Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, 1> towards_an_axis(
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& modes) {
  constexpr std::array<Eigen::Index, 3> axes{1, 2, 0};
  constexpr double alike = 1e-6;
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> best;
  double greatest = 0;
  for (const Eigen::Index axis : axes)
    for (Eigen::Index at = axis; at < modes.rows(); at += 6) {
      const double moves = modes.row(at).norm();
      if (!(moves > (1 + alike) * greatest)) continue;
      greatest = moves;
      best = modes.row(at).adjoint() / moves;
    }
  return best;
}

template <class Scalar>
void turn_towards_axes(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& modes) {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  for (Eigen::Index done = 0; done < modes.cols(); ++done) {
    const Matrix left = modes.rightCols(modes.cols() - done);
    const Matrix first = towards_an_axis<Scalar>(left);
    if (first.size() == 0) return;
    // Its orthogonal complement follows in the other columns.
    Matrix turn = Eigen::HouseholderQR<Matrix>(first).householderQ();
    turn.col(0) = first;
    modes.rightCols(modes.cols() - done) = left * turn;
  }
}

template Eigen::VectorXd towards_an_axis(const Eigen::MatrixXd&);
template void turn_towards_axes(Eigen::MatrixXd&);
template void turn_towards_axes(Eigen::MatrixXcd&);

double greatest_displacement(const Eigen::VectorXd& dq) {
  double greatest = 0;
  for (Eigen::Index at = 0; at < dq.size(); at += 6) greatest = std::max(greatest, dq.segment<3>(at).norm());
  return greatest;
}

}  // namespace plumb
