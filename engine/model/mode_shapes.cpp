#include "engine/model/mode_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {

Eigen::MatrixXd starting_modes(int nodes, Eigen::Index wished) {
  Eigen::MatrixXd X(6 * nodes, std::min<Eigen::Index>(wished, nodes));
  for (Eigen::Index k = 0; k < X.cols(); ++k)
    for (Eigen::Index i = 0; i < X.rows(); ++i)
      X(i, k) = std::cos(static_cast<double>((k + 1) * (i / 6)) / nodes + 1.3 * static_cast<double>(k) +
                         2.1 * static_cast<double>(i % 6));
  return X;
}

Eigen::VectorXd towards_an_axis(const Eigen::MatrixXd& modes) {
  constexpr std::array<Eigen::Index, 3> axes{1, 2, 0};
  constexpr double alike = 1e-6;
  Eigen::VectorXd best;
  double greatest = 0;
  for (const Eigen::Index axis : axes)
    for (Eigen::Index at = axis; at < modes.rows(); at += 6) {
      const double moves = modes.row(at).norm();
      if (!(moves > (1 + alike) * greatest)) continue;
      greatest = moves;
      best = modes.row(at).transpose() / moves;
    }
  return best;
}

double greatest_displacement(const Eigen::VectorXd& dq) {
  double greatest = 0;
  for (Eigen::Index at = 0; at < dq.size(); at += 6) greatest = std::max(greatest, dq.segment<3>(at).norm());
  return greatest;
}

}  // namespace plumb
