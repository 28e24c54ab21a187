// The cable pendulum by a program of its own, which shares nothing with Plumb: the figures of
// cases/references/pendulum_converged.toml. Gradient-deficient ANCF elements with Green's strain and the
// geometric curvature (J. Gerstmayr and A. A. Shabana, 2006), from scalar products alone; a dense mass
// matrix, inverted once; the classical Runge-Kutta method.
//
//     c++ -O2 -std=c++20 -o independent_cable tests/independent_cable.cpp && ./independent_cable [ELEMENTS
//     [STEPS]]
//
// STEPS is per 0.02 s, between two rows: t, y of the middle, x and z of the tip.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using Numbers = std::vector<double>;

constexpr double length = 1, axial = 40, bending = 7.95774715459e-5, mass = 8e-3, gravity = 9.81, spin = 4;

struct Rule {
  std::vector<double> x, w;  // on [0, 1]
};

const Rule five{{0.5, 0.5 - 0.26923465505284155, 0.5 + 0.26923465505284155, 0.5 - 0.45308992296933199,
                 0.5 + 0.45308992296933199},
                {0.28444444444444444, 0.23931433524968324, 0.23931433524968324, 0.11846344252809454,
                 0.11846344252809454}};
const Rule three{{0.5, 0.5 - 0.38729833462074170, 0.5 + 0.38729833462074170},
                 {0.44444444444444444, 0.27777777777777778, 0.27777777777777778}};

/// Hermite's cubic shape functions over an element of length l, and their derivatives in x.
std::array<double, 4> shape(double s, double l, int derivative) {
  if (derivative == 0)
    return {1 + s * s * (2 * s - 3), l * s * (1 + s * (s - 2)), s * s * (3 - 2 * s), l * s * s * (s - 1)};
  if (derivative == 1)
    return {6 * s * (s - 1) / l, 1 + s * (3 * s - 4), 6 * s * (1 - s) / l, s * (3 * s - 2)};
  return {(12 * s - 6) / (l * l), (6 * s - 4) / l, (6 - 12 * s) / (l * l), (6 * s - 2) / l};
}

class Pendulum {
 public:
  explicit Pendulum(int elements)
      : elements_(elements), l_(length / elements), scalar_(2 * elements + 2), inverse_(scalar_ * scalar_) {
    Numbers M(scalar_ * scalar_);
    weight_.resize(scalar_);
    for (int e = 0; e < elements_; ++e)
      for (std::size_t g = 0; g < five.x.size(); ++g) {
        const auto s = shape(five.x[g], l_, 0);
        for (std::size_t i = 0; i < 4; ++i) {
          weight_[place(e, i)] += mass * l_ * five.w[g] * s[i];
          for (std::size_t j = 0; j < 4; ++j)
            M[place(e, i) * scalar_ + place(e, j)] += mass * l_ * five.w[g] * s[i] * s[j];
        }
      }
    hold(M);
    invert(M);
  }

  Numbers start(int derivative) const {
    Numbers q(3 * scalar_);
    for (int node = 0; node <= elements_; ++node) {
      const auto k = 6 * static_cast<std::size_t>(node);
      // Straight along x; turning about y with `spin`: v = spin e_y × r.
      if (derivative == 0) {
        q[k] = l_ * node;
        q[k + 3] = 1;
      } else {
        q[k + 2] = -spin * l_ * node;
        q[k + 5] = -spin;
      }
    }
    return q;
  }

  Numbers acceleration(const Numbers& q) const {
    Numbers f(3 * scalar_);
    for (std::size_t i = 0; i < scalar_; ++i) f[3 * i + 1] = -gravity * weight_[i];
    for (int e = 0; e < elements_; ++e) {
      for (std::size_t g = 0; g < five.x.size(); ++g) stretch(e, five.x[g], five.w[g] * l_, q, f);
      for (std::size_t g = 0; g < three.x.size(); ++g) bend(e, three.x[g], three.w[g] * l_, q, f);
    }
    for (int c = 0; c < 3; ++c) f[static_cast<std::size_t>(c)] = 0;  // the joint
    Numbers a(3 * scalar_);
    for (std::size_t i = 0; i < scalar_; ++i)
      for (std::size_t j = 0; j < scalar_; ++j) {
        const double m = inverse_[i * scalar_ + j];
        for (std::size_t c = 0; c < 3; ++c) a[3 * i + c] += m * f[3 * j + c];
      }
    return a;
  }

 private:
  static std::size_t place(int element, std::size_t i) { return 2 * static_cast<std::size_t>(element) + i; }

  std::array<double, 3> at(int e, const std::array<double, 4>& s, const Numbers& q) const {
    std::array<double, 3> r{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t c = 0; c < 3; ++c) r[c] += s[i] * q[3 * place(e, i) + c];
    return r;
  }

  static double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /// ½ EA ε², ε = ½ (r'·r' − 1).
  void stretch(int e, double x, double w, const Numbers& q, Numbers& f) const {
    const auto d = shape(x, l_, 1);
    const auto slope = at(e, d, q);
    const double tension = axial * 0.5 * (dot(slope, slope) - 1);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t c = 0; c < 3; ++c) f[3 * place(e, i) + c] -= w * tension * d[i] * slope[c];
  }

  /// ½ EI κ², κ² = (a c − b²)/a³ with a = r'·r', b = r'·r'', c = r''·r''.
  void bend(int e, double x, double w, const Numbers& q, Numbers& f) const {
    const auto d = shape(x, l_, 1), dd = shape(x, l_, 2);
    const auto slope = at(e, d, q), second = at(e, dd, q);
    const double a = dot(slope, slope), b = dot(slope, second), c2 = dot(second, second), a3 = a * a * a;
    const double by_a = c2 / a3 - 3 * (a * c2 - b * b) / (a3 * a), by_b = -2 * b / a3, by_c = a / a3;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        f[3 * place(e, i) + c] -= w * 0.5 * bending *
                                  (by_a * 2 * slope[c] * d[i] + by_b * (second[c] * d[i] + slope[c] * dd[i]) +
                                   by_c * 2 * second[c] * dd[i]);
  }

  void hold(Numbers& M) const {
    for (std::size_t j = 0; j < scalar_; ++j) M[j] = M[j * scalar_] = 0;
    M[0] = 1;
  }

  /// By Gauss's and Jordan's elimination; M is symmetric and positive definite.
  void invert(Numbers& M) {
    for (std::size_t i = 0; i < scalar_; ++i) inverse_[i * scalar_ + i] = 1;
    for (std::size_t k = 0; k < scalar_; ++k) {
      const double pivot = M[k * scalar_ + k];
      for (std::size_t j = 0; j < scalar_; ++j) {
        M[k * scalar_ + j] /= pivot;
        inverse_[k * scalar_ + j] /= pivot;
      }
      for (std::size_t i = 0; i < scalar_; ++i) {
        const double factor = M[i * scalar_ + k];
        if (i == k || factor == 0) continue;
        for (std::size_t j = 0; j < scalar_; ++j) {
          M[i * scalar_ + j] -= factor * M[k * scalar_ + j];
          inverse_[i * scalar_ + j] -= factor * inverse_[k * scalar_ + j];
        }
      }
    }
  }

  int elements_;
  double l_;
  std::size_t scalar_;
  Numbers inverse_, weight_;
};

Numbers sum(const Numbers& a, double factor, const Numbers& b) {
  Numbers c = a;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] += factor * b[i];
  return c;
}

}  // namespace

int main(int count, char** arguments) {
  const int elements = count > 1 ? std::atoi(arguments[1]) : 64,
            steps = count > 2 ? std::atoi(arguments[2]) : 400;
  if (elements < 2 || elements % 2 != 0 || steps < 1) return 2;
  const Pendulum pendulum(elements);
  constexpr double interval = 0.02;
  const double h = interval / steps;
  Numbers q = pendulum.start(0), v = pendulum.start(1);
  for (int row = 1; row <= 100; ++row) {
    for (int step = 0; step < steps; ++step) {
      const Numbers a1 = pendulum.acceleration(q), v2 = sum(v, h / 2, a1);
      const Numbers a2 = pendulum.acceleration(sum(q, h / 2, v)), v3 = sum(v, h / 2, a2);
      const Numbers a3 = pendulum.acceleration(sum(q, h / 2, v2)), v4 = sum(v, h, a3);
      const Numbers a4 = pendulum.acceleration(sum(q, h, v3));
      q = sum(sum(sum(sum(q, h / 6, v), h / 3, v2), h / 3, v3), h / 6, v4);
      v = sum(sum(sum(sum(v, h / 6, a1), h / 3, a2), h / 3, a3), h / 6, a4);
    }
    const auto middle = static_cast<std::size_t>(3 * elements), tip = static_cast<std::size_t>(6 * elements);
    std::printf("  [%.2f, %10.7f, %10.7f, %10.7f],\n", interval * row, q[middle + 1], q[tip], q[tip + 2]);
  }
}
