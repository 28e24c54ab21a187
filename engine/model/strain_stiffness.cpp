#include "engine/model/strain_stiffness.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/model/cable.h"
#include "engine/model/cross_matrix.h"
#include "engine/model/quadrature.h"

namespace plumb {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
/// r' and r'' (upper and lower three rows) of several vectors.
using Changes = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Of the 12 coordinates of an element (a vector each column) of length l, at x in [0, 1] of it: the Hermite
/// functions with r₁ − r₀ taken first, which is small beside either.
template <class Coordinates>
Changes changes_at(const Coordinates& q, double x, double l) {
  const auto g0 = q.template middleRows<3>(3), g1 = q.template middleRows<3>(9);
  const Eigen::MatrixXd d = (q.template middleRows<3>(6) - q.template topRows<3>()) / l;
  Changes result(6, q.cols());
  result.template topRows<3>() =
      (6 * x * (1 - x)) * d + (1 - 4 * x + 3 * x * x) * g0 + (3 * x * x - 2 * x) * g1;
  result.template bottomRows<3>() = ((6 - 12 * x) * d + (6 * x - 4) * g0 + (6 * x - 2) * g1) / l;
  return result;
}

/// Second derivatives of ½ ε² by r' = g.
Eigen::Matrix3d of_stretching(const Vec3& g, bool green) {
  const Eigen::Matrix3d along = g * g.transpose();
  if (green) return along + 0.5 * (g.squaredNorm() - 1) * Eigen::Matrix3d::Identity();
  const double length = g.norm(), across = (length - 1) / length;
  return across * Eigen::Matrix3d::Identity() + ((1 - across) / (length * length)) * along;
}

/// Second derivatives of ½ κ² = ½ |n|² (g·g)⁻ᵖ with n = g × c by g = r' and c = r''.
Matrix6 of_bending(const Vec3& g, const Vec3& c, double p) {
  const Vec3 n = g.cross(c);
  const double a = g.squaredNorm(), u = std::pow(a, -p), b = n.squaredNorm();
  Eigen::Matrix<double, 3, 6> by;  // of n
  by << -cross_matrix(c), cross_matrix(g);
  Eigen::Matrix<double, 6, 1> db = 2 * by.transpose() * n, du = Eigen::Matrix<double, 6, 1>::Zero();
  du.head<3>() = (-2 * p * u / a) * g;
  Matrix6 ddb = 2 * by.transpose() * by, ddu = Matrix6::Zero();
  // n · (δg × δc) both ways.
  ddb.topRightCorner<3, 3>() -= 2 * cross_matrix(n);
  ddb.bottomLeftCorner<3, 3>() += 2 * cross_matrix(n);
  ddu.topLeftCorner<3, 3>() =
      (4 * p * (p + 1) * u / (a * a)) * g * g.transpose() - (2 * p * u / a) * Eigen::Matrix3d::Identity();
  return 0.5 * (u * ddb + db * du.transpose() + du * db.transpose() + b * ddu);
}

}  // namespace

StrainStiffness::StrainStiffness(const Cable& cable, const Eigen::VectorXd& q) : cable_(cable), q_(q) {}

Eigen::MatrixXd StrainStiffness::of(const Eigen::MatrixXd& X) const {
  const ElementConstants& c = cable_.constants();
  const double EA = c.axial_stiffness * c.length, EI = c.bending_stiffness * c.length;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(X.cols(), X.cols());
  const auto add = [&](const auto& Y, const auto& H) { sum.noalias() += Y.transpose() * (H * Y); };
  for (int e = 0; e < cable_.elements(); ++e) {
    const Eigen::Matrix<double, 12, 1> q = q_.segment<12>(6 * e);
    const auto x = X.middleRows<12>(6 * e);
    if (c.straight) {
      const Vec3 chord = (q.segment<3>(6) - q.head<3>()) / c.length;
      const Eigen::Matrix<double, 3, Eigen::Dynamic> change =
          (x.middleRows<3>(6) - x.topRows<3>()) / c.length;
      add(change, EA * of_stretching(chord, c.green));
      continue;
    }
    for (const QuadraturePoint& point : stretching_rule(c.full)) {
      const Vec3 slope = changes_at(q, point.x, c.length).topRows<3>();
      const Eigen::Matrix<double, 3, Eigen::Dynamic> change = changes_at(x, point.x, c.length).topRows<3>();
      add(change, EA * point.weight * of_stretching(slope, c.green));
    }
    if (EI == 0) continue;
    for (const QuadraturePoint& point : bending_rule(c.full)) {
      const Changes at = changes_at(q, point.x, c.length);
      add(changes_at(x, point.x, c.length),
          EI * point.weight * of_bending(at.topRows<3>(), at.bottomRows<3>(), c.green ? 3 : 2));
    }
  }
  return sum;
}

double StrainStiffness::scale_of(const Eigen::VectorXd& x) const {
  const ElementConstants& c = cable_.constants();
  double sum = 0;
  for (int e = 0; e < cable_.elements(); ++e) {
    const Eigen::Matrix<double, 12, 1> own = x.segment<12>(6 * e);
    for (const QuadraturePoint& point : gauss_rule(3))
      sum += point.weight * (c.straight ? (own.segment<3>(6) - own.head<3>()) / c.length
                                        : Vec3(changes_at(own, point.x, c.length).topRows<3>()))
                                .squaredNorm();
  }
  return c.axial_stiffness * c.length * sum;
}

}  // namespace plumb
