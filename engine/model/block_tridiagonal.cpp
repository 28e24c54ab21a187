#include "engine/model/block_tridiagonal.h"

namespace plumb {

void BlockTridiagonal::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  const int count = nodes();
  y.setZero(6 * count);
  for (int i = 0; i < count; ++i) {
    const auto own = x.segment<6>(6 * i);
    y.segment<6>(6 * i) += diagonal(i).selfadjointView<Eigen::Lower>() * own;
    if (i + 1 == count) break;
    y.segment<6>(6 * i) += below(i).transpose() * x.segment<6>(6 * i + 6);
    y.segment<6>(6 * i + 6) += below(i) * own;
  }
}

Eigen::MatrixXd BlockTridiagonal::dense() const {
  Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(6 * nodes(), 6 * nodes());
  for (int i = 0; i < nodes(); ++i) {
    lower.block<6, 6>(6 * i, 6 * i) = diagonal(i);
    if (i + 1 < nodes()) lower.block<6, 6>(6 * i + 6, 6 * i) = below(i);
  }
  return lower.selfadjointView<Eigen::Lower>();
}

}  // namespace plumb
