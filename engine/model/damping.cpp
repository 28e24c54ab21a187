#include "engine/model/damping.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/model/cross_matrix.h"

namespace plumb {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Vector12 = Eigen::Matrix<double, 12, 1>;

/// k of a slope g and r'' = c, with rates dg and dc, and what is made of it.
struct Bending {
  Vec3 g, c, dg, dc;
  double m, a, mu;  // exponent, g·g, |g|⁻ᵐ
  Vec3 n, k, dk;    // g × c, k and its rate
  Matrix3 k_by_g, k_by_c;
  double total;  // κ² + s²
  Vec3 p;        // P k̇

  Bending(const Vec3& g_, const Vec3& c_, const Vec3& dg_, const Vec3& dc_, bool green, double straight)
      : g(g_), c(c_), dg(dg_), dc(dc_), m(green ? 3 : 2), a(g.squaredNorm()), mu(std::pow(a, -0.5 * m)) {
    n = g.cross(c);
    k = mu * n;
    k_by_g = -mu * cross_matrix(c) - (m * mu / a) * n * g.transpose();
    k_by_c = mu * cross_matrix(g);
    dk = k_by_g * dg + k_by_c * dc;
    total = k.squaredNorm() + straight * straight;
    p = (k * k.dot(dk) + straight * straight * dk) / total;
  }

  /// P x.
  Matrix3 projected(const Matrix3& x, double straight) const {
    return (k * (k.transpose() * x) + straight * straight * x) / total;
  }

  /// The derivative of p by g or c, of which k has the derivative `by` and k̇ `dby`.
  Matrix3 p_by(const Matrix3& by, const Matrix3& dby, double straight) const {
    return projected(dby, straight) + (k.dot(dk) * by + k * (dk.transpose() * by)) / total -
           (2 / total) * p * (k.transpose() * by);
  }
};

/// Derivatives of k̇ by g and c, at given rates.
struct RateOfBending {
  Matrix3 by_g, by_c;

  explicit RateOfBending(const Bending& b) {
    const double turn = b.m * b.mu * b.g.dot(b.dg) / b.a;
    const Vec3 e = b.dg.cross(b.c) + b.g.cross(b.dc);
    by_g = -b.mu * cross_matrix(b.dc) + turn * cross_matrix(b.c) -
           (b.m * b.mu / b.a) * (e * b.g.transpose() + b.n * b.dg.transpose()) +
           ((b.m + 2) * turn / b.a) * b.n * b.g.transpose();
    by_c = b.mu * cross_matrix(b.dg) - turn * cross_matrix(b.g);
  }
};

/// Second derivatives of p·k by (g, c) at a fixed p; that by c twice is 0.
struct SecondOfBending {
  Matrix3 gg, gc;

  SecondOfBending(const Bending& b, const Vec3& p) {
    const double share = b.m * b.mu / b.a, pn = p.dot(b.n);
    const Vec3 cp = b.c.cross(p), pg = p.cross(b.g);
    gg = -share * (b.g * cp.transpose() + cp * b.g.transpose() + pn * Matrix3::Identity()) +
         (share * (b.m + 2) * pn / b.a) * b.g * b.g.transpose();
    gc = -b.mu * cross_matrix(p) - share * b.g * pg.transpose();
  }
};

void add_block(const std::array<double, 4>& row, const std::array<double, 4>& column, const Matrix3& H,
               Block12& K) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      K.block<3, 3>(3 * static_cast<int>(i), 3 * static_cast<int>(j)) += (row[i] * column[j]) * H;
}

void add_vector(const std::array<double, 4>& shape, const Vec3& force, Vector12& F) {
  for (std::size_t i = 0; i < 4; ++i) F.segment<3>(3 * static_cast<int>(i)) += shape[i] * force;
}

}  // namespace

Damping::Damping(const DampingSpec& spec, const ElementConstants& element, int elements)
    : spec_(spec),
      elements_(elements),
      by_mass_(spec.mass),
      axial_(spec.material * element.axial_stiffness),
      bending_(spec.material * element.bending_stiffness),
      green_(element.green),
      straight_(1e-10 / (element.length * elements)) {
  const double l = element.length;
  if (element.straight) {
    axial_points_ = {{l, {-1 / l, 0, 1 / l, 0}, {}}};
    bending_ = 0;
    return;
  }
  axial_points_ = stretching_points(element);
  bending_points_ = bending_points(element);
}

Damping Damping::in_units(const OwnUnits& units, const ElementConstants& element) const {
  return {{spec_.mass * units.time, spec_.material / units.time}, element, elements_};
}

void Damping::add_force(const Eigen::VectorXd& q, const Eigen::VectorXd& v, Eigen::VectorXd& f) const {
  if (!of_material()) return;
  for (int e = 0; e < elements_; ++e) {
    const double *at = q.data() + 6 * e, *rate = v.data() + 6 * e;
    Vector12 F = Vector12::Zero();
    for (const IntegrationPoint& point : axial_points_) {
      const Vec3 g = combine(point.slope, at);
      const double a = g.squaredNorm();
      if (!(a > slope_floor * slope_floor)) continue;
      const double strain_rate = g.dot(combine(point.slope, rate)) / (green_ ? 1 : a);
      add_vector(point.slope, (-axial_ * point.weight * strain_rate) * g, F);
    }
    for (const IntegrationPoint& point : bending_points_) {
      if (bending_ == 0) break;
      const Vec3 g = combine(point.slope, at);
      if (!(g.norm() > slope_floor)) continue;
      const Bending b(g, combine(point.bend, at), combine(point.slope, rate), combine(point.bend, rate),
                      green_, straight_);
      const double w = -bending_ * point.weight;
      add_vector(point.slope, w * (b.k_by_g.transpose() * b.p), F);
      add_vector(point.bend, w * (b.k_by_c.transpose() * b.p), F);
    }
    f.segment<12>(6 * e) += F;
  }
}

void Damping::add_system(const Eigen::VectorXd& q, const Eigen::VectorXd& v, double stiffness_factor,
                         double rate_factor, GeneralBlockTridiagonal<double>& A) const {
  if (!of_material()) return;
  for (int e = 0; e < elements_; ++e) {
    const double *at = q.data() + 6 * e, *rate = v.data() + 6 * e;
    Block12 K = Block12::Zero();
    for (const IntegrationPoint& point : axial_points_) {
      const Vec3 g = combine(point.slope, at), dg = combine(point.slope, rate);
      const double a = g.squaredNorm(), stretching = g.dot(dg);
      if (!(a > slope_floor * slope_floor)) continue;
      const double scale = green_ ? 1 : 1 / a, w = axial_ * point.weight * scale;
      Matrix3 H = (rate_factor * w) * g * g.transpose() +
                  (stiffness_factor * w) * (g * dg.transpose() + stretching * Matrix3::Identity());
      if (!green_) H -= (2 * stiffness_factor * w * stretching / a) * g * g.transpose();
      add_block(point.slope, point.slope, H, K);
    }
    for (const IntegrationPoint& point : bending_points_) {
      if (bending_ == 0) break;
      const Vec3 g = combine(point.slope, at);
      if (!(g.norm() > slope_floor)) continue;
      const Bending b(g, combine(point.bend, at), combine(point.slope, rate), combine(point.bend, rate),
                      green_, straight_);
      const RateOfBending changes(b);
      const SecondOfBending second(b, b.p);
      const double w = bending_ * point.weight, by_q = stiffness_factor * w, by_v = rate_factor * w;
      const Matrix3 p_g =
          by_q * b.p_by(b.k_by_g, changes.by_g, straight_) + by_v * b.projected(b.k_by_g, straight_);
      const Matrix3 p_c =
          by_q * b.p_by(b.k_by_c, changes.by_c, straight_) + by_v * b.projected(b.k_by_c, straight_);
      add_block(point.slope, point.slope, b.k_by_g.transpose() * p_g + by_q * second.gg, K);
      add_block(point.slope, point.bend, b.k_by_g.transpose() * p_c + by_q * second.gc, K);
      add_block(point.bend, point.slope, b.k_by_c.transpose() * p_g + by_q * second.gc.transpose(), K);
      add_block(point.bend, point.bend, b.k_by_c.transpose() * p_c, K);
    }
    A.add_element(e, K);
  }
}

}  // namespace plumb
