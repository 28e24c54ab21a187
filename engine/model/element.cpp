#include "engine/model/element.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/model/hermite.h"
#include "engine/model/quadrature.h"

namespace plumb {

Element::Element(double axial_stiffness, double bending_stiffness, double length, StrainModel strain,
                 QuadratureRule quadrature)
    : axial_stiffness_(axial_stiffness),
      bending_stiffness_(bending_stiffness),
      length_(length),
      strain_(strain) {
  const bool full = quadrature == QuadratureRule::full;
  axial_ = points(full ? gauss_rule(5) : lobatto_rule(), length);
  bending_ = points(gauss_rule(full ? 3 : 2), length);
}

std::vector<Element::Point> Element::points(std::span<const QuadraturePoint> rule, double length) {
  std::vector<Point> result;
  for (const QuadraturePoint& p : rule)
    result.push_back({p.weight * length, Hermite::slopes(p.x, length), Hermite::curvatures(p.x, length)});
  return result;
}

void Element::tangent(const double* q, Matrix12& K) const {
  using Matrix3 = Eigen::Matrix3d;
  K.setZero();
  for (const Point& point : axial_) {
    const Vec3 g = combine(point.s1, q);
    const double a = g.squaredNorm();
    if (collapsed(a)) continue;
    Matrix3 H;
    if (strain_ == StrainModel::green_geometric) {
      H = g * g.transpose();
      H.diagonal().array() += 0.5 * (a - 1);
    } else {
      const double root = std::sqrt(a);
      H = g * g.transpose() / (a * root);
      H.diagonal().array() += 1 - 1 / root;
    }
    H *= axial_stiffness_ * point.weight;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        K.block<3, 3>(3 * i, 3 * j) +=
            (point.s1[static_cast<std::size_t>(i)] * point.s1[static_cast<std::size_t>(j)]) * H;
  }
  const double p = exponent();
  for (const Point& point : bending_) {
    const Vec3 g = combine(point.s1, q), c = combine(point.s2, q);
    const double a = g.squaredNorm(), b = c.squaredNorm(), d = g.dot(c);
    if (collapsed(a)) continue;
    const Vec3 n = g.cross(c);
    const double nn = n.squaredNorm();
    // Second derivatives of ½ n·n / a^p. With u = ∂(½n·n)/∂g = c × n and w = ∂(½n·n)/∂c = n × g:
    const Vec3 u = c.cross(n), w = n.cross(g);
    Matrix3 gg = -c * c.transpose() - (2 * p / a) * (u * g.transpose() + g * u.transpose()) +
                 (2 * p * (p + 1) * nn / (a * a)) * g * g.transpose();
    gg.diagonal().array() += b - p * nn / a;
    Matrix3 cg = 2 * c * g.transpose() - g * c.transpose() - (2 * p / a) * w * g.transpose();
    cg.diagonal().array() -= d;
    Matrix3 cc = -g * g.transpose();
    cc.diagonal().array() += a;
    const double scale = bending_stiffness_ * point.weight / power(a);
    for (int i = 0; i < 4; ++i) {
      const double si1 = scale * point.s1[static_cast<std::size_t>(i)];
      const double si2 = scale * point.s2[static_cast<std::size_t>(i)];
      for (int j = 0; j < 4; ++j) {
        const double sj1 = point.s1[static_cast<std::size_t>(j)], sj2 = point.s2[static_cast<std::size_t>(j)];
        K.block<3, 3>(3 * i, 3 * j) +=
            (si1 * sj1) * gg + (si2 * sj1) * cg + (si1 * sj2) * cg.transpose() + (si2 * sj2) * cc;
      }
    }
  }
}

double Element::strain(const Vec3& slope) const {
  const double a = slope.squaredNorm();
  return strain_ == StrainModel::green_geometric ? 0.5 * (a - 1) : std::sqrt(a) - 1;
}

double Element::curvature(const Vec3& slope, const Vec3& slope_rate) const {
  const double a = std::max(slope.squaredNorm(), slope_floor * slope_floor);
  return slope.cross(slope_rate).norm() / std::sqrt(power(a));
}

}  // namespace plumb
