#include "engine/integrate/methods/critical_modes.h"

#include <algorithm>
#include <cmath>

#include "engine/base/dense.h"
#include "engine/model/cable.h"
#include "engine/model/mode_shapes.h"

namespace plumb {
namespace {

/// Modes as columns, and the eigenvalue of K next to 0, 1/s².
struct Modes {
  Eigen::MatrixXd shapes;
  double nearest = 0;
};

/// Those of the eigenvalues next to 0: eigenvectors of K⁻¹ M by orthogonal iteration (Parlett 1998, section
/// 14.1).
Modes modes_next_to_zero(LoadedCable& loaded) {
  constexpr int vectors = 4, iterations = 12;
  constexpr double as_near = 1e3;  // as the nearest
  const Cable& cable = loaded.cable();
  const Eigen::Index n = cable.size();
  Eigen::MatrixXd X = starting_modes(cable.nodes(), vectors), Y = X;
  Eigen::Index near = 1;
  double nearest = 0;
  Eigen::VectorXd x, y;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    Y.resize(n, X.cols());
    for (Eigen::Index k = 0; k < X.cols(); ++k) {
      x = X.col(k);
      cable.supports().apply(x);
      X.col(k) = x;
      cable.mass().multiply(x, y);
      cable.supports().apply(y);
      loaded.solve(y);
      Y.col(k) = y;
    }
    // Rayleigh and Ritz: M-orthonormal combinations, those of the greatest 1/eigenvalue first.
    Eigen::MatrixXd MY(n, Y.cols());
    for (Eigen::Index k = 0; k < Y.cols(); ++k) {
      y = Y.col(k);
      cable.mass().multiply(y, x);
      cable.supports().apply(x);
      MY.col(k) = x;
    }
    // Y spans the space that X did, turned by K⁻¹ M: eigenvectors of (Yᵀ M X, Yᵀ M Y) have eigenvalues of K.
    const Eigen::VectorXd size = (Y.transpose() * MY).diagonal().cwiseSqrt().cwiseMax(1e-300);
    const Eigen::MatrixXd scale = size.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd B = scale * (Y.transpose() * MY) * scale;
    const Eigen::MatrixXd A = scale * (MY.transpose() * X) * scale;
    const SymmetricEigen ritz = symmetric_eigen(0.5 * (A + A.transpose()), B);
    if (ritz.values.size() == 0) break;
    X.resize(n, ritz.values.size());
    std::vector<Eigen::Index> order(static_cast<std::size_t>(X.cols()));
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
    std::ranges::sort(order, {}, [&](Eigen::Index k) { return std::abs(ritz.values[k]); });
    near = 0;
    nearest = ritz.values[order[0]];
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (std::abs(ritz.values[order[k]]) <= as_near * std::abs(ritz.values[order[0]])) ++near;
      x = Y * (scale * ritz.vectors.col(order[k]));
      X.col(static_cast<Eigen::Index>(k)) = x / loaded.norm(x);
    }
  }
  return {X.leftCols(near), nearest};
}

}  // namespace

CriticalMode critical_mode(LoadedCable& loaded) {
  constexpr double round_off = 1e-14, least_shown = 1e-9;
  constexpr double as_good_as_zero = 1e-4;
  const Modes found = modes_next_to_zero(loaded);
  const Eigen::MatrixXd& modes = found.shapes;
  const Eigen::VectorXd work = modes.transpose() * loaded.load();
  CriticalMode mode;
  const Cable& cable = loaded.cable();
  const double L = cable.length(), mass = cable.constants().mass_per_length;
  // Of a cantilever, squared; of a cable that does not bend, that along it.
  const double EI = cable.element().bending_stiffness(), EA = cable.element().axial_stiffness();
  const double usual = (EI > 0 ? 12 * EI / (L * L) : EA) / (mass * L * L);
  mode.gives_way = std::abs(found.nearest) <= as_good_as_zero * usual;
  mode.by_load = loaded.has_a_side() && work.norm() > round_off * modes.norm() * loaded.load().norm();
  Eigen::VectorXd shares = mode.by_load ? Eigen::VectorXd(work / work.norm()) : towards_an_axis(modes);
  if (shares.size() == 0) shares = Eigen::VectorXd::Unit(modes.cols(), 0);
  mode.shape = modes * shares;
  mode.shape /= loaded.norm(mode.shape);
  Eigen::Index place = 0;
  for (Eigen::Index at = 0; at < mode.shape.size(); at += 6)
    if (mode.shape.segment<3>(at).norm() > mode.shape.segment<3>(place).norm()) place = at;
  mode.at = static_cast<double>(place / 6) / cable.elements();
  mode.direction = mode.shape.segment<3>(place).normalized();
  for (double& component : mode.direction)
    if (std::abs(component) < least_shown) component = 0;
  return mode;
}

}  // namespace plumb
