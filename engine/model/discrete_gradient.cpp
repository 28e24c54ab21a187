#include "engine/model/discrete_gradient.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/model/cable.h"

namespace plumb {
namespace {

using Matrix3 = Eigen::Matrix3d;

/// The mean force of stretching is c(a₀, a₁) times the mean slope.
struct Axial {
  double c, by_a1;

  Axial(bool green, double stiffness, double a0, double a1) {
    if (green) {
      c = stiffness * 0.25 * (a0 + a1 - 2);
      by_a1 = stiffness * 0.25;
    } else {
      const double root0 = std::sqrt(a0), root1 = std::sqrt(a1), sum = root0 + root1;
      c = stiffness * (1 - 2 / sum);
      by_a1 = stiffness / (sum * sum * root1);
    }
  }
};

/// s(a) = a^−p with its difference quotient S(a₀, a₁) and their derivatives by a₁.
struct Power {
  double mean, quotient, mean_by_a1, quotient_by_a1;

  Power(bool green, double a0, double a1) {
    const double p = green ? 3 : 2;
    const double s0 = green ? 1 / (a0 * a0 * a0) : 1 / (a0 * a0);
    const double s1 = green ? 1 / (a1 * a1 * a1) : 1 / (a1 * a1);
    const double sums = green ? a0 * a0 + a0 * a1 + a1 * a1 : a0 + a1;
    const double sums_by_a1 = green ? a0 + 2 * a1 : 1;
    mean = 0.5 * (s0 + s1);
    mean_by_a1 = -0.5 * p * s1 / a1;
    quotient = -sums * s0 * s1;
    quotient_by_a1 = -sums_by_a1 * s0 * s1 + p * sums * s0 * s1 / a1;
  }
};

}  // namespace

DiscreteGradient::DiscreteGradient(const Cable& cable)
    : elements_(cable.elements()),
      axial_stiffness_(cable.constants().axial_stiffness),
      bending_stiffness_(cable.constants().bending_stiffness),
      green_(cable.constants().green),
      chain_(cable.chain()),
      axial_(stretching_points(cable.constants())),
      bending_(bending_points(cable.constants())) {}

bool DiscreteGradient::add_element(const double* q0, const double* q1, Vector12& D, Matrix12* K) const {
  if (chain_) {
    const Link& link = chain_->link();
    const auto chord = [](const double* q) -> Vec3 {
      return Eigen::Map<const Vec3>(q + 6) - Eigen::Map<const Vec3>(q);
    };
    const Vec3 d0 = chord(q0), d1 = chord(q1);
    if (!link.is_whole(d0) || !link.is_whole(d1)) return false;
    const Vec3 pull = link.discrete_gradient(d0, d1);
    D.segment<3>(0) -= pull;
    D.segment<3>(6) += pull;
    if (K == nullptr) return true;
    const Matrix3 H = link.discrete_tangent(d0, d1);
    K->block<3, 3>(0, 0) += H;
    K->block<3, 3>(6, 6) += H;
    K->block<3, 3>(0, 6) -= H;
    K->block<3, 3>(6, 0) -= H;
    return true;
  }
  const double floor = slope_floor * slope_floor;
  const auto add_force = [&](const std::array<double, 4>& s, const Vec3& f) {
    for (int i = 0; i < 4; ++i) D.segment<3>(3 * i) += s[static_cast<std::size_t>(i)] * f;
  };
  const auto add_block = [&](const std::array<double, 4>& row, const std::array<double, 4>& column,
                             const Matrix3& H) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        K->block<3, 3>(3 * i, 3 * j) +=
            (row[static_cast<std::size_t>(i)] * column[static_cast<std::size_t>(j)]) * H;
  };
  for (const IntegrationPoint& point : axial_) {
    const Vec3 g0 = combine(point.slope, q0), g1 = combine(point.slope, q1), g = 0.5 * (g0 + g1);
    const double a0 = g0.squaredNorm(), a1 = g1.squaredNorm();
    if (!(a0 > floor) || !(a1 > floor)) return false;
    const Axial axial(green_, axial_stiffness_ * point.weight, a0, a1);
    add_force(point.slope, axial.c * g);
    if (K == nullptr) continue;
    Matrix3 H = (2 * axial.by_a1) * g * g1.transpose();
    H.diagonal().array() += 0.5 * axial.c;
    add_block(point.slope, point.slope, H);
  }
  for (const IntegrationPoint& point : bending_) {
    const Vec3 g0 = combine(point.slope, q0), g1 = combine(point.slope, q1), g = 0.5 * (g0 + g1);
    const Vec3 c0 = combine(point.bend, q0), c1 = combine(point.bend, q1), c = 0.5 * (c0 + c1);
    const double a0 = g0.squaredNorm(), a1 = g1.squaredNorm(), a = 0.5 * (a0 + a1);
    if (!(a0 > floor) || !(a1 > floor)) return false;
    const double b1 = c1.squaredNorm(), b = 0.5 * (c0.squaredNorm() + b1);
    const double d1 = g1.dot(c1), d = 0.5 * (g0.dot(c0) + d1);
    const double nn = 0.5 * (g0.cross(c0).squaredNorm() + g1.cross(c1).squaredNorm());
    const Power s(green_, a0, a1);
    // With W = ½k (ab − d²) s: twice the quotients by a and b, and that by d.
    const double k = bending_stiffness_ * point.weight;
    const double A = k * (s.mean * b + nn * s.quotient), B = k * s.mean * a, C = -k * s.mean * d;
    add_force(point.slope, A * g + C * c);
    add_force(point.bend, B * c + C * g);
    if (K == nullptr) continue;
    const double A_a = k * (s.mean_by_a1 * b + 0.5 * b1 * s.quotient + nn * s.quotient_by_a1);
    const double A_b = k * 0.5 * (s.mean + a1 * s.quotient), A_d = -k * d1 * s.quotient;
    const double B_a = k * (s.mean_by_a1 * a + 0.5 * s.mean);
    const double C_a = -k * s.mean_by_a1 * d, C_d = -k * 0.5 * s.mean;
    const Vec3 C_g = 2 * C_a * g1 + C_d * c1, C_c = C_d * g1;  // by g₁ and by c₁
    Matrix3 gg = g * (2 * A_a * g1 + A_d * c1).transpose() + c * C_g.transpose();
    Matrix3 gc = g * (2 * A_b * c1 + A_d * g1).transpose() + c * C_c.transpose();
    Matrix3 cg = (2 * B_a) * c * g1.transpose() + g * C_g.transpose();
    Matrix3 cc = g * C_c.transpose();
    gg.diagonal().array() += 0.5 * A;
    gc.diagonal().array() += 0.5 * C;
    cg.diagonal().array() += 0.5 * C;
    cc.diagonal().array() += 0.5 * B;
    add_block(point.slope, point.slope, gg);
    add_block(point.slope, point.bend, gc);
    add_block(point.bend, point.slope, cg);
    add_block(point.bend, point.bend, cc);
  }
  return true;
}

std::optional<int> DiscreteGradient::force(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                           Eigen::VectorXd& f) const {
  f.setZero(q0.size());
  std::optional<int> collapsed;
  for (int e = 0; e < elements_; ++e) {
    Vector12 D = Vector12::Zero();
    if (!add_element(q0.data() + 6 * e, q1.data() + 6 * e, D, nullptr) && !collapsed) collapsed = e;
    f.segment<12>(6 * e) -= D;
  }
  return collapsed;
}

void DiscreteGradient::add_tangent(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, double factor,
                                   GeneralBlockTridiagonal<double>& A) const {
  for (int e = 0; e < elements_; ++e) {
    Vector12 D = Vector12::Zero();
    Matrix12 K = Matrix12::Zero();
    add_element(q0.data() + 6 * e, q1.data() + 6 * e, D, &K);
    K *= factor;
    A.add_element(e, K);
  }
}

}  // namespace plumb
