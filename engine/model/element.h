#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <complex>
#include <vector>

#include "engine/input/case.h"
#include "engine/kernels/kernels.h"
#include "engine/model/quadrature.h"

namespace plumb {

inline double real_part(double x) {
  return x;
}
inline double real_part(const std::complex<double>& x) {
  return x.real();
}

/// The elastic part of the gradient-deficient ANCF cable element: two nodes with position and slope, no
/// shear, no torsion (Gerstmayr and Shabana 2006; Recuero and Negrut 2016). The strain energy is ∫ ½EA ε² +
/// ½EI κ² dx.
///
/// Element coordinates are the 12 numbers (r₀, r'₀, r₁, r'₁). The curvature enters as κ² = |r' × r''|² /
/// (r'·r')^p with p = 3 (geometric) or 2 (material), which is smooth for a straight cable where κ itself is
/// not.
///
/// Energies and force are templates over the scalar so that tests can differentiate them by complex steps.
class Element {
 public:
  using Matrix12 = Eigen::Matrix<double, 12, 12>;

  /// EA in N and EI in N m², both ≥ 0; element length l in m, > 0.
  Element(double axial_stiffness, double bending_stiffness, double length, StrainModel strain,
          QuadratureRule quadrature);

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

  /// Strain ε of a slope vector r'.
  double strain(const Vec3& slope) const;
  /// Curvature κ (1/m) from r' and r'' (1/m); of a collapsed slope, that at the floor.
  double curvature(const Vec3& slope, const Vec3& slope_rate) const;

  double axial_stiffness() const { return axial_stiffness_; }
  double bending_stiffness() const { return bending_stiffness_; }
  double length() const { return length_; }

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
    return strain_ == StrainModel::green_geometric ? T(a * a * a) : T(a * a);
  }
  double exponent() const { return strain_ == StrainModel::green_geometric ? 3 : 2; }

  static bool collapsed(double slope_squared) { return !(slope_squared > slope_floor * slope_floor); }

  double axial_stiffness_;
  double bending_stiffness_;
  double length_;
  StrainModel strain_;
  std::vector<Point> axial_;
  std::vector<Point> bending_;
};

template <class T>
T Element::axial_energy(const T* q) const {
  using std::sqrt;
  T energy = 0;
  for (const Point& point : axial_) {
    const Vector<T> g = combine(point.s1, q);
    const T a = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    const T epsilon = strain_ == StrainModel::green_geometric ? T(0.5 * (a - 1.0)) : T(sqrt(a) - 1.0);
    energy += 0.5 * axial_stiffness_ * point.weight * epsilon * epsilon;
  }
  return energy;
}

template <class T>
T Element::bending_energy(const T* q) const {
  T energy = 0;
  for (const Point& point : bending_) {
    const Vector<T> g = combine(point.s1, q), c = combine(point.s2, q);
    const Vector<T> n = cross<T>(g, c);
    const T a = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (collapsed(real_part(a))) continue;
    energy += 0.5 * bending_stiffness_ * point.weight * (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / power(a);
  }
  return energy;
}

template <class T>
T Element::add_force(const T* q, T* f) const {
  using std::sqrt;
  T least = 1e300;
  for (const Point& point : axial_) {
    const Vector<T> g = combine(point.s1, q);
    const T a = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (!(real_part(a) >= real_part(least))) least = a;
    if (collapsed(real_part(a))) continue;
    const T stress = strain_ == StrainModel::green_geometric ? T(0.5 * (a - 1.0)) : T(1.0 - 1.0 / sqrt(a));
    spread<T>(point.s1, (axial_stiffness_ * point.weight * stress) * g, f);
  }
  for (const Point& point : bending_) {
    const Vector<T> g = combine(point.s1, q), c = combine(point.s2, q);
    const T a = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (!(real_part(a) >= real_part(least))) least = a;
    if (collapsed(real_part(a))) continue;
    const Vector<T> n = cross<T>(g, c);
    const T nn = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    // With W = ½EI n·n / a^p:  ∂W/∂g = EI (c × n / a^p − p n·n g / a^(p+1)),  ∂W/∂c = EI n × g / a^p.
    const T scale = bending_stiffness_ * point.weight / power(a);
    spread<T>(point.s1, scale * (cross<T>(c, n) - (exponent() * nn / a) * g), f);
    spread<T>(point.s2, scale * cross<T>(n, g), f);
  }
  return least;
}

}  // namespace plumb
