#include "engine/integrate/symmetric_motion.h"

#include <algorithm>
#include <cmath>

#include "engine/base/dense.h"
#include "engine/model/cable.h"
#include "engine/model/inertia.h"

namespace plumb {
namespace {

using Matrix3 = Eigen::Matrix3d;

/// Σ x xᵀ of three of each six numbers, over the greatest of these: its eigenvectors of value 0 are the
/// directions in which there is nothing.
Matrix3 spread(const Eigen::VectorXd& nodal, int offset) {
  Matrix3 sum = Matrix3::Zero();
  double greatest = 0;
  for (Eigen::Index at = offset; at < nodal.size(); at += 6)
    greatest = std::max(greatest, nodal.segment<3>(at).lpNorm<Eigen::Infinity>());
  if (!(greatest > 0)) return sum;
  for (Eigen::Index at = offset; at < nodal.size(); at += 6) {
    const Vec3 x = nodal.segment<3>(at) / greatest;
    sum += x * x.transpose();
  }
  return sum / static_cast<double>(nodal.size());
}

/// The projection across the line in which there is something; zero where that is no line.
Matrix3 projection_across(const Matrix3& spread) {
  constexpr double nothing = 1e-13;  // of squares: 3e-7 of what is seen elsewhere
  const auto& [values, vectors] = symmetric_eigen(spread);
  if (values[1] > nothing * values[2]) return Matrix3::Zero();
  const Vec3 line = vectors.col(2);
  return Matrix3::Identity() - line * line.transpose();
}

/// Whether some motion in the directions of P grows faster than at `rate` (1/s).
bool grows(const Cable& cable, const Eigen::VectorXd& q, const Matrix3& P, double rate) {
  BlockTridiagonal A(cable.nodes());
  cable.system(q, rate * rate, 1, A);
  cable.supports().apply(A);
  for (int node = 0; node < A.nodes(); ++node) {
    Block6 D = A.diagonal(node).selfadjointView<Eigen::Lower>();
    Block6 below = A.below(node);
    for (int i = 0; i < 6; i += 3)
      for (int j = 0; j < 6; j += 3) {
        const double size = i == j ? D.block<3, 3>(i, j).diagonal().cwiseAbs().maxCoeff() : 0;
        D.block<3, 3>(i, j) = (P * D.block<3, 3>(i, j) * P).eval() + size * (Matrix3::Identity() - P);
        below.block<3, 3>(i, j) = (P * below.block<3, 3>(i, j) * P).eval();
      }
    A.diagonal(node) = D;
    A.below(node) = below;
  }
  return negative_eigenvalues(A).value_or(0) > 0;
}

}  // namespace

double unstable_since(const Cable& cable, const Trajectory& run) {
  constexpr std::size_t most_looks = 32, most_elements = 65536;  // looked at, in all
  constexpr double growth = 1e3, least_share = 0.25;
  if (cable.is_rigid() || !cable.conservative() || run.q.size() < 2 || !(run.times.back() > 0)) return -1;
  const double rate = std::log(growth) / run.times.back();
  const std::size_t wished =
      std::clamp(most_elements / static_cast<std::size_t>(cable.elements()), std::size_t{1}, most_looks);
  const std::size_t stride = (run.q.size() + wished - 1) / wished;
  Matrix3 seen = spread(cable.external_force(), 0);
  double since = -1, looks = 0, unstable = 0;
  for (std::size_t k = 0; k < run.q.size(); ++k) {
    for (const int offset : {0, 3}) seen += spread(run.q[k], offset) + spread(run.v[k], offset);
    const Matrix3 P = projection_across(seen);
    if (P.isZero()) break;
    if (k % stride != 0) continue;
    ++looks;
    if (!grows(cable, run.q[k], P, rate)) continue;
    ++unstable;
    if (since < 0) since = run.times[k];
  }
  return unstable >= least_share * looks ? since : -1;
}

}  // namespace plumb
