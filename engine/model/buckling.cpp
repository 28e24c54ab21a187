#include "engine/model/buckling.h"

#include <algorithm>
#include <cmath>

#include "engine/base/dense.h"
#include "engine/model/block_lu.h"
#include "engine/model/cable.h"
#include "engine/model/inertia.h"
#include "engine/model/mode_shapes.h"

namespace plumb {
namespace {

/// Change of the load over which the stiffness is differentiated, as a share of that which gives a strain or
/// a slope of 1.
constexpr double difference = 1e-4;

/// K and its derivative along dq, with supports.
struct Pencil {
  BlockTridiagonal K, dK;

  Pencil(const Cable& cable, const Eigen::VectorXd& q, const Eigen::VectorXd& dq)
      : K(cable.nodes()), dK(cable.nodes()) {
    BlockTridiagonal before(cable.nodes());
    cable.system(q, 0, 1, K);
    cable.system(q + dq, 0, 1, dK);
    cable.system(q - dq, 0, 1, before);
    for (int node = 0; node < cable.nodes(); ++node) {
      dK.diagonal(node) = 0.5 * (dK.diagonal(node) - before.diagonal(node));
      dK.below(node) = 0.5 * (dK.below(node) - before.below(node));
    }
    cable.supports().apply(K);
  }
};

}  // namespace

std::optional<Buckling> first_buckling(const Cable& cable, const Eigen::VectorXd& q) {
  constexpr int vectors = 4, iterations = 60;
  constexpr double alike = 1e-6;
  BlockTridiagonal K(cable.nodes());
  cable.system(q, 0, 1, K);
  cable.supports().apply(K);
  BlockLu<double> factors;
  if (negative_eigenvalues(K) != 0 || factors.factor(GeneralBlockTridiagonal<double>(K))) return std::nullopt;
  Eigen::VectorXd way = cable.external_force();
  cable.supports().apply(way);
  factors.solve(way);
  // What bends the cable makes it give way to no side.
  const Vec3& straight = cable.supports().direction();
  for (Eigen::Index at = 0; at < way.size(); at += 3) {
    const Vec3 along = straight.dot(way.segment<3>(at)) * straight;
    way.segment<3>(at) = along;
  }
  // The linear way under the whole load may be far longer than the cable.
  double longest = 0;
  for (Eigen::Index at = 0; at < way.size(); at += 6)
    longest = std::max({longest, way.segment<3>(at).norm() / cable.length(), way.segment<3>(at + 3).norm()});
  if (!(longest > 0) || !std::isfinite(longest)) return std::nullopt;
  const double share = difference / longest;
  const Pencil pencil(cable, q, share * way);

  Eigen::MatrixXd X = starting_modes(cable.nodes(), vectors), Y = X;
  Eigen::VectorXd values, x, y;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    Eigen::MatrixXd KX = X, dX = X;
    for (Eigen::Index k = 0; k < X.cols(); ++k) {
      x = X.col(k);
      cable.supports().apply(x);
      X.col(k) = x;
      pencil.K.multiply(x, y);
      KX.col(k) = y;
      pencil.dK.multiply(x, y);
      y *= -1 / share;
      cable.supports().apply(y);
      dX.col(k) = y;
    }
    const Eigen::VectorXd size = (X.transpose() * KX).diagonal().cwiseSqrt().cwiseMax(1e-300);
    const Eigen::MatrixXd scale = size.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd A = scale * (X.transpose() * dX) * scale, B = scale * (X.transpose() * KX) * scale;
    const SymmetricEigen ritz = symmetric_eigen(0.5 * (A + A.transpose()), 0.5 * (B + B.transpose()));
    if (ritz.values.size() == 0) return std::nullopt;
    // Rising: the greatest 1/λ is the last. A shift to the middle of the spectrum would be faster and is not
    // needed.
    values = ritz.values.reverse();
    const Eigen::MatrixXd turned = scale * ritz.vectors.rowwise().reverse();
    X = X * turned;
    if (iteration + 1 == iterations) break;
    Y = dX * turned;
    for (Eigen::Index k = 0; k < Y.cols(); ++k) {
      y = Y.col(k);
      factors.solve(y);
      // Those that a pull would need, of the other sign, are as strong: shifted so that pressed ones come
      // first.
      X.col(k) = y + std::max(0.0, -values.minCoeff()) * X.col(k);
    }
  }
  if (!(values[0] * greatest_buckling_load >= 1)) return std::nullopt;
  Eigen::Index same = 1;
  while (same < values.size() && values[same] > (1 - alike) * values[0]) ++same;
  const Eigen::MatrixXd modes = X.leftCols(same);
  const Eigen::VectorXd shares = towards_an_axis(modes);
  if (shares.size() == 0) return std::nullopt;
  Buckling result{1 / values[0], modes * shares};
  result.shape /= greatest_displacement(result.shape);
  return result;
}

}  // namespace plumb
