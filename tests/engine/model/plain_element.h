#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "engine/model/element.h"
#include "engine/model/hermite.h"
#include "engine/model/quadrature.h"

namespace plumb {

inline double real_part(double x) {
  return x;
}
inline double real_part(const std::complex<double>& x) {
  return x.real();
}

/// The forces of an element as its equations state them, point by point and vector by vector: what the
/// kernels are held and timed against. Element coordinates are the 12 numbers (r₀, r'₀, r₁, r'₁). Energies
/// and force are templates over the scalar, so that they can be differentiated by complex steps.
class PlainElement : public Element {
 public:
  using Matrix12 = Eigen::Matrix<double, 12, 12>;

  PlainElement(double axial_stiffness, double bending_stiffness, double length, StrainModel strain,
               QuadratureRule quadrature)
      : Element(axial_stiffness, bending_stiffness, length, strain) {
    const bool full = quadrature == QuadratureRule::full;
    axial_ = points(full ? gauss_rule(5) : lobatto_rule(), length);
    bending_ = points(gauss_rule(full ? 3 : 2), length);
  }

  /// Strain energy of stretching, J.
  template <class T>
  T axial_energy(const T* q) const;

  /// Strain energy of bending, J; points with a collapsed slope are left out.
  template <class T>
  T bending_energy(const T* q) const;

  /// Adds the elastic force −∂U/∂q to f (12 numbers: N and N m). Returns the least r'·r' met at an
  /// integration point: below slope_floor² the force is incomplete.
  template <class T>
  T add_force(const T* q, T* f) const;

  /// Sets the tangent K = ∂²U/∂q², symmetric 12 by 12.
  void tangent(const double* q, Matrix12& K) const;

 private:
  template <class T>
  using Vector = Eigen::Matrix<T, 3, 1>;

  /// Shape function derivatives at an integration point; they are the same for every element of a mesh.
  struct Point {
    double weight;             // times l, m
    std::array<double, 4> s1;  // first derivatives
    std::array<double, 4> s2;  // second derivatives
  };

  static std::vector<Point> points(std::span<const QuadraturePoint> rule, double length);

  /// Eigen's own cross product conjugates complex vectors, which a complex step must not be.
  template <class T>
  static Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  template <class T>
  static Vector<T> combine(const std::array<double, 4>& s, const T* q) {
    Vector<T> sum;
    for (int k = 0; k < 3; ++k) sum[k] = s[0] * q[k] + s[1] * q[3 + k] + s[2] * q[6 + k] + s[3] * q[9 + k];
    return sum;
  }

  template <class T>
  static void spread(const std::array<double, 4>& s, const Vector<T>& p, T* f) {
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 3; ++k) f[3 * i + k] -= s[static_cast<std::size_t>(i)] * p[k];
  }

  /// a^p with p = 3 or 2.
  template <class T>
  T power(const T& a) const {
    return strain_model() == StrainModel::green_geometric ? T(a * a * a) : T(a * a);
  }
  double exponent() const { return strain_model() == StrainModel::green_geometric ? 3 : 2; }

  static bool collapsed(double slope_squared) { return !(slope_squared > slope_floor * slope_floor); }

  std::vector<Point> axial_;
  std::vector<Point> bending_;
};

template <class T>
T PlainElement::axial_energy(const T* q) const {
  using std::sqrt;
  T energy = 0;
  for (const Point& point : axial_) {
    const Vector<T> g = combine(point.s1, q);
    const T a = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    const T epsilon = strain_model() == StrainModel::green_geometric ? T(0.5 * (a - 1.0)) : T(sqrt(a) - 1.0);
    energy += 0.5 * axial_stiffness() * point.weight * epsilon * epsilon;
  }
  return energy;
}

template <class T>
T PlainElement::bending_energy(const T* q) const {
  T energy = 0;
  for (const Point& point : bending_) {
    const Vector<T> g = combine(point.s1, q), c = combine(point.s2, q);
    const Vector<T> n = cross<T>(g, c);
    const T a = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (collapsed(real_part(a))) continue;
    energy += 0.5 * bending_stiffness() * point.weight * (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / power(a);
  }
  return energy;
}

template <class T>
T PlainElement::add_force(const T* q, T* f) const {
  using std::sqrt;
  T least = 1e300;
  for (const Point& point : axial_) {
    const Vector<T> g = combine(point.s1, q);
    const T a = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (!(real_part(a) >= real_part(least))) least = a;
    if (collapsed(real_part(a))) continue;
    const T stress =
        strain_model() == StrainModel::green_geometric ? T(0.5 * (a - 1.0)) : T(1.0 - 1.0 / sqrt(a));
    spread<T>(point.s1, (axial_stiffness() * point.weight * stress) * g, f);
  }
  for (const Point& point : bending_) {
    const Vector<T> g = combine(point.s1, q), c = combine(point.s2, q);
    const T a = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (!(real_part(a) >= real_part(least))) least = a;
    if (collapsed(real_part(a))) continue;
    const Vector<T> n = cross<T>(g, c);
    const T nn = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    // With W = ½EI n·n / a^p:  ∂W/∂g = EI (c × n / a^p − p n·n g / a^(p+1)),  ∂W/∂c = EI n × g / a^p.
    const T scale = bending_stiffness() * point.weight / power(a);
    spread<T>(point.s1, scale * (cross<T>(c, n) - (exponent() * nn / a) * g), f);
    spread<T>(point.s2, scale * cross<T>(n, g), f);
  }
  return least;
}

inline std::vector<PlainElement::Point> PlainElement::points(std::span<const QuadraturePoint> rule,
                                                             double length) {
  std::vector<Point> result;
  for (const QuadraturePoint& p : rule)
    result.push_back({p.weight * length, Hermite::slopes(p.x, length), Hermite::curvatures(p.x, length)});
  return result;
}

inline void PlainElement::tangent(const double* q, Matrix12& K) const {
  using Matrix3 = Eigen::Matrix3d;
  K.setZero();
  for (const Point& point : axial_) {
    const Vec3 g = combine(point.s1, q);
    const double a = g.squaredNorm();
    if (collapsed(a)) continue;
    Matrix3 H;
    if (strain_model() == StrainModel::green_geometric) {
      H = g * g.transpose();
      H.diagonal().array() += 0.5 * (a - 1);
    } else {
      const double root = std::sqrt(a);
      H = g * g.transpose() / (a * root);
      H.diagonal().array() += 1 - 1 / root;
    }
    H *= axial_stiffness() * point.weight;
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
    const double scale = bending_stiffness() * point.weight / power(a);
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

}  // namespace plumb
