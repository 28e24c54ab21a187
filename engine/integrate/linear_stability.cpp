#include "engine/integrate/linear_stability.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <span>

#include "engine/integrate/methods/bdf_formula.h"
#include "engine/integrate/methods/gauss_table.h"
#include "engine/integrate/methods/nystrom_pair.h"
#include "engine/integrate/methods/structural_schemes.h"
#include "engine/integrate/sundials/arkode_tables.h"
#include "engine/model/dense_eigenvalues.h"

namespace plumb {
namespace {

using Complex = std::complex<double>;

// Time is counted in steps here: h = 1 and ω = z. Maps of a step act on (z q, v), so that a vibration is a
// circle.

double radius_of_pair(const Eigen::Matrix2d& map) {
  const double half_trace = 0.5 * map.trace(), half_difference = 0.5 * (map(0, 0) - map(1, 1));
  const double discriminant = half_difference * half_difference + map(0, 1) * map(1, 0);
  if (discriminant < 0) return std::sqrt(map.determinant());
  return std::abs(half_trace) + std::sqrt(discriminant);
}

/// The map of a step that takes (q, v) to (q, v).
template <class Step>
Eigen::Matrix2d map_of(double z, const Step& step) {
  Eigen::Matrix2d map;
  for (int column = 0; column < 2; ++column) {
    double q = column == 0 ? 1 / z : 0, v = column;
    step(q, v);
    map.col(column) << z * q, v;
  }
  return map;
}

Eigen::Matrix2d verlet_map(double z) {
  return map_of(z, [&](double& q, double& v) {
    const double middle = v - 0.5 * z * z * q;
    q += middle;
    v = middle - 0.5 * z * z * q;
  });
}

Eigen::Matrix2d linearly_implicit_euler_map(double z) {
  return map_of(z, [&](double& q, double& v) {
    v = (v - z * z * q) / (1 + z * z);
    q += v;
  });
}

Eigen::Matrix2d nystrom_map(double z) {
  using Pair = NystromPair;
  return map_of(z, [&](double& q, double& v) {
    Pair::Row k{};
    double end_q = q + v, end_v = v;
    for (std::size_t i = 0; i < Pair::stages; ++i) {
      double stage = q + Pair::c[i] * v;
      for (std::size_t j = 0; j < i; ++j) stage += Pair::a[i][j] * k[j];
      k[i] = -z * z * stage;
      end_q += Pair::b[i] * k[i];
      end_v += Pair::velocity[i] * k[i];
    }
    q = end_q;
    v = end_v;
  });
}

/// |1 + iz bᵀ (1 − iz A)⁻¹ (1, …, 1)|: the stability function of a Runge-Kutta method at iz (Hairer and
/// Wanner 1996, equation IV.3.2).
double runge_kutta_amplification(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double z) {
  const Eigen::Index s = b.size();
  const Complex iz(0, z);
  const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(s, s) - iz * A;
  const Eigen::VectorXcd stages = system.partialPivLu().solve(Eigen::VectorXcd::Ones(s));
  return std::abs(1.0 + iz * (b.cast<Complex>().transpose() * stages).value());
}

double runge_kutta_amplification(const ArkodeTable& table, double z) {
  const int s = table->stages;
  Eigen::MatrixXd A(s, s);
  Eigen::VectorXd b(s);
  for (int i = 0; i < s; ++i) {
    b[i] = table->b[i];
    for (int j = 0; j < s; ++j) A(i, j) = table->A[i][j];
  }
  return runge_kutta_amplification(A, b, z);
}

double rk4_amplification(double z) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A(1, 0) = A(2, 1) = 0.5;
  A(3, 2) = 1;
  return runge_kutta_amplification(A, Eigen::Vector4d(1, 2, 2, 1) / 6, z);
}

double structural_amplification(const StructuralScheme& s, double z) {
  Eigen::Matrix3d map;  // of (z q, v, a/z)
  for (int column = 0; column < 3; ++column) {
    const double q = column == 0 ? 1 / z : 0, v = column == 1 ? 1 : 0, a = column == 2 ? z : 0;
    const double known = q + v + s.position_old * a;
    const double point = s.point * known + (1 - s.point) * q;
    const double x = -(s.mass_old * a + z * z * (s.force_new * point + s.force_old * q)) /
                     (s.mass_new + z * z * s.force_new * s.point * s.position_new);
    map.col(column) << z * (known + s.position_new * x), v + s.velocity_old * a + s.velocity_new * x, x / z;
  }
  return spectral_radius(map);
}

/// Of the roots ζ of (1 − iz reach) ζᵏ = Σ oldⱼ ζᵏ⁻¹⁻ʲ.
double backward_differentiation_amplification(int order, double z) {
  constexpr std::array<double, BdfFormula::highest_order> before{1, 2, 3, 4, 5};
  const std::span<const double> steps_before = before;
  const BdfFormula formula(steps_before.first(static_cast<std::size_t>(order)));
  Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(order, order);
  for (int j = 0; j < order; ++j)
    companion(0, j) = formula.old[static_cast<std::size_t>(j)] / Complex(1, -z * formula.reach);
  for (int i = 1; i < order; ++i) companion(i, i - 1) = 1;
  return spectral_radius(companion);
}

}  // namespace

std::optional<double> amplification(const MethodSpec& method, double z) {
  const bool chooses_steps = method.rtol && !method.step;
  if (chooses_steps) return std::nullopt;
  // As z goes to 0 the largest root of every method that converges goes to 1; 0 itself has no scale.
  if (z == 0) z = std::numeric_limits<double>::min();
  const auto order = [&] { return static_cast<int>(method.parameters.at("order")); };
  if (method.name == "velocity-verlet") return radius_of_pair(verlet_map(z));
  if (method.name == "rk4") return rk4_amplification(z);
  if (method.name == "runge-kutta-nystrom") return radius_of_pair(nystrom_map(z));
  if (method.name == "arkode-erk") return runge_kutta_amplification(explicit_table(order()), z);
  if (method.name == "linearly-implicit-euler") return radius_of_pair(linearly_implicit_euler_map(z));
  if (method.name == "arkode-dirk") return runge_kutta_amplification(implicit_table(order()), z);
  if (method.name == "gauss") {
    const GaussTable table;
    return runge_kutta_amplification(table.A, table.b, z);
  }
  if (method.name == "bdf") return backward_differentiation_amplification(order(), z);
  if (const auto scheme = structural_scheme(method)) return structural_amplification(*scheme, z);
  return std::nullopt;
}

std::optional<double> stability_limit(const MethodSpec& method) {
  // Growth by less is round-off of a root on the unit circle.
  constexpr double round_off = 1e-9, small_round_off = 1e-12;
  constexpr double fine = 0.01, fine_until = 20, ratio = 1.05;
  // Beyond, the roots of every method here have all but settled, and those of some are so close that their
  // round-off is more.
  constexpr double last = 1e3;
  if (!amplification(method, 1)) return std::nullopt;
  const auto grows = [&](double z) { return *amplification(method, z) > 1 + round_off; };
  double stable = 0;
  for (double z = fine; z <= last; z = z < fine_until ? z + fine : z * ratio) {
    if (!grows(z)) {
      stable = z;
      continue;
    }
    double unstable = z;
    while (unstable - stable > 1e-12 * unstable) {
      const double middle = 0.5 * (stable + unstable);
      (grows(middle) ? unstable : stable) = middle;
    }
    // What grows at half of that already, and by less than round_off only because growth is a power of z,
    // grows at every step.
    return *amplification(method, 0.5 * stable) > 1 + small_round_off ? 0 : stable;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace plumb
