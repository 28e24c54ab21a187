#include "engine/model/complex_modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/dense.h"
#include "engine/base/interrupt.h"
#include "engine/model/mode_shapes.h"

namespace plumb {
namespace {

using Complex = std::complex<double>;
using ComplexFactors = BlockLu<Complex>;

/// A linear map of real vectors, of complex ones.
template <class Times>
Eigen::VectorXcd of_complex(const Times& times, const Eigen::VectorXcd& x) {
  Eigen::VectorXd re, im;
  times(x.real(), re);
  times(x.imag(), im);
  Eigen::VectorXcd result(x.size());
  result.real() = re;
  result.imag() = im;
  return result;
}

class Solver {
 public:
  Solver(const SmallMotions& motions, int count)
      : motions_(motions),
        count_(static_cast<std::size_t>(count)),
        base_(lowest_modes(motions, 2 * count + beyond)) {}

  ComplexModes solve() {
    ComplexModes result;
    if (!base_.failure.empty()) {
      result.failure = base_.failure;
      return result;
    }
    std::vector<ComplexMode> modes = projected(base_.shapes.cols());
    // On fewer of them, which tells how much is left out.
    const std::vector<ComplexMode> less = projected(base_.shapes.cols() - base_.shapes.cols() / 4);
    for (std::size_t k = 0; k < modes.size(); ++k) {
      ComplexMode& mode = modes[k];
      // Those alike the last are turned together with it.
      if (k >= count_ && !alike(result.modes.back(), mode)) break;
      if (!mode.rigid_body && !refine(mode) && !(k < less.size() && is_settled(mode, less[k]))) {
        result.failure = fmt::format("Newton's iteration for mode {} did not converge", k + 1);
        return result;
      }
      if (!mode.rigid_body) measure(mode);
      result.modes.push_back(std::move(mode));
    }
    turn_those_alike(result.modes);
    if (const auto same = found_twice(result.modes))
      result.failure = fmt::format("modes {} and {} are the same", *same, *same + 1);
    result.modes.resize(std::min(count_, result.modes.size()));
    return result;
  }

 private:
  Eigen::VectorXcd M(const Eigen::VectorXcd& x) const {
    return of_complex([&](const Eigen::VectorXd& a, Eigen::VectorXd& b) { motions_.mass_times(a, b); }, x);
  }
  Eigen::VectorXcd D(const Eigen::VectorXcd& x) const {
    return of_complex([&](const Eigen::VectorXd& a, Eigen::VectorXd& b) { motions_.rates_times(a, b); }, x);
  }
  Eigen::VectorXcd K(const Eigen::VectorXcd& x) const {
    return of_complex([&](const Eigen::VectorXd& a, Eigen::VectorXd& b) { motions_.stiffness_times(a, b); },
                      x);
  }

  /// The modes of the projected system, in order, with the rigid-body motions as they are known.
  std::vector<ComplexMode> projected(Eigen::Index m) const {
    constexpr double as_good_as_zero = 1e-4, as_good_as_rigid = 1e-6, as_good_as_real = 1e-9;
    const Eigen::Index rigid = base_.rigid_body;
    const Eigen::MatrixXd shapes = base_.shapes.leftCols(m);
    const Eigen::VectorXd squares = base_.squares.head(m);
    Eigen::MatrixXd Dp(m, m), Kp(m, m);
    Eigen::VectorXd y;
    for (Eigen::Index k = 0; k < m; ++k) {
      motions_.rates_times(shapes.col(k), y);
      Dp.col(k) = shapes.transpose() * y;
      Kp.col(k).setZero();
      if (!motions_.has_symmetric_stiffness()) {
        motions_.stiffness_times(shapes.col(k), y);
        Kp.col(k) = shapes.transpose() * y;
      }
    }
    // Of the symmetric part what is known better.
    Kp = (0.5 * (Kp - Kp.transpose())).eval();
    Kp.diagonal() += squares;
    double slowest = std::sqrt(squares.cwiseAbs().maxCoeff());
    for (Eigen::Index k = rigid; k < m; ++k)
      if (squares[k] != 0) slowest = std::min(slowest, std::sqrt(std::abs(squares[k])));
    const double unit = slowest > 0 ? slowest : 1;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * m, 2 * m);
    A.topRightCorner(m, m).setIdentity();
    A.bottomLeftCorner(m, m) = -Kp / (unit * unit);
    A.bottomRightCorner(m, m) = -Dp / unit;
    const GeneralEigen eigen = general_eigen(A);
    std::vector<ComplexMode> modes;
    for (Eigen::Index k = 0; k < 2 * m; ++k) {
      const Complex exponent = unit * eigen.values[k];
      if (exponent.imag() < 0) continue;
      const Eigen::VectorXcd x = eigen.vectors.col(k).head(m).normalized();
      const double rigid_share = x.head(rigid).squaredNorm(), size = std::abs(exponent);
      if (1 - rigid_share < as_good_as_rigid && exponent.imag() <= as_good_as_zero * unit) continue;
      const double b = x.dot(Dp * x).real(), c = x.dot(Kp * x).real();
      ComplexMode mode;
      mode.exponent = exponent;
      if (exponent.imag() <= as_good_as_real * size) {
        mode.exponent = exponent.real();
        // Of two that decay, or of one that grows and one that decays, the other.
        if (c > 0 ? size > std::sqrt(c) : exponent.real() < 0) continue;
      }
      mode.damping_ratio = c > 0 ? b / (2 * std::sqrt(c)) : 0;
      mode.shape = shapes * x;
      modes.push_back(std::move(mode));
    }
    for (Eigen::Index k = 0; k < rigid; ++k) {
      ComplexMode mode;
      mode.shape = shapes.col(k);
      mode.rigid_body = true;
      modes.push_back(std::move(mode));
    }
    const auto rank = [&](const ComplexMode& mode) {
      const bool grows = mode.exponent.real() > as_good_as_real * std::abs(mode.exponent) && !mode.rigid_body;
      const double size = std::abs(mode.exponent);
      return std::pair(grows ? 0 : mode.rigid_body ? 1 : 2, grows ? -size : natural(mode));
    };
    std::ranges::stable_sort(modes, {}, rank);
    return modes;
  }

  /// |λ|, or of an overdamped mode what it would be without damping.
  static double natural(const ComplexMode& mode) {
    const double size = std::abs(mode.exponent), ratio = mode.damping_ratio;
    // The slower exponent is −ω (ζ − √(ζ² − 1)).
    return mode.exponent.imag() == 0 && ratio > 1 ? size * (ratio + std::sqrt(ratio * ratio - 1)) : size;
  }

  /// Newton's iteration for a pair of λ and φ.
  bool refine(ComplexMode& mode) const {
    constexpr int iterations = 20;
    constexpr double good = 1e-13, good_enough = 1e-5;
    Eigen::VectorXcd x = mode.shape;
    const Complex first = mode.exponent;
    double change = 1;
    for (int i = 0; i < iterations; ++i) {
      stop_if_interrupted();
      ComplexFactors factors;
      // Singular: it is the exponent.
      if (motions_.factor(mode.exponent, factors)) break;
      Eigen::VectorXcd u = 2.0 * mode.exponent * M(x) + D(x);
      const Eigen::VectorXcd along = M(x);
      factors.solve(u);
      const Complex size = along.dot(u);
      if (!std::isfinite(std::abs(size)) || size == 0.0) break;
      const Complex next = mode.exponent - along.dot(x) / size;
      const double last = change;
      change = std::abs(next - mode.exponent) / std::abs(next);
      // Round-off makes no progress.
      if (change >= last && (last < good_enough || i > 2)) break;
      const bool was_real = mode.exponent.imag() == 0;
      mode.exponent = was_real ? Complex(next.real()) : next;
      x = u / std::sqrt(u.dot(M(u)).real());
      if (change <= good) break;
    }
    if (!(change <= good_enough)) {
      mode.exponent = first;
      return false;
    }
    mode.shape = x;
    return true;
  }

  /// Whether what was left out has no part in a projected mode: the same mode of a smaller projection tells.
  /// On meshes so fine that the entries of K leave nothing of the first modes, that is all there is to tell
  /// it by.
  static bool is_settled(const ComplexMode& mode, const ComplexMode& of_less) {
    constexpr double settled = 1e-6;
    return std::abs(mode.exponent - of_less.exponent) <= settled * std::abs(mode.exponent);
  }

  /// What is said of a mode.
  void measure(ComplexMode& mode) const {
    sharpen(mode);
    const Eigen::VectorXcd& x = mode.shape;
    const Eigen::VectorXcd Mx = M(x), Dx = D(x), Kx = K(x);
    const Complex l = mode.exponent;
    mode.residual =
        (l * l * Mx + l * Dx + Kx).norm() / (std::norm(l) * Mx.norm() + std::abs(l) * Dx.norm() + Kx.norm());
    const double b = x.dot(Dx).real(), c = form_of(x, true).real();
    mode.damping_ratio = l.imag() != 0 ? -l.real() / std::abs(l) : c > 0 ? b / (2 * std::sqrt(c)) : 0;
  }

  /// x* K x, or xᵀ K x, of the symmetric part of K from strains.
  Complex form_of(const Eigen::VectorXcd& x, bool conjugate) const {
    const double re = motions_.stiffness_along(x.real()), im = motions_.stiffness_along(x.imag());
    if (conjugate) return re + im;
    return {re - im, motions_.stiffness_along(x.real() + x.imag()) - re - im};
  }

  /// Takes λ from aλ² + bλ + c = 0 with what φ makes of M, D and K, that of K from strains: where the entries
  /// of K cancel that is far better, as the error of φ enters by its square. That is so of φᵀ where all
  /// matrices are symmetric, and of φ* where nothing but Coriolis's forces makes D differ from 0.
  void sharpen(ComplexMode& mode) const {
    constexpr double near = 1e-4, apart = 0.5;
    if (!motions_.has_symmetric_stiffness()) return;
    const Eigen::VectorXcd& x = mode.shape;
    const bool spins = !motions_.cable().spin().isZero(0);
    const Eigen::VectorXcd left = spins ? Eigen::VectorXcd(x.conjugate()) : x;
    const auto by = [&](const Eigen::VectorXcd& y) { return (left.transpose() * y)(0); };
    const Complex a = by(M(x)), b = by(D(x)), c = form_of(x, spins);
    // Of two modes alike that go round φᵀ M φ is 0.
    if (std::abs(a) < apart) return;
    const Complex middle = -b / (2.0 * a), root = std::sqrt(middle * middle - c / a);
    const Complex one = middle + root, other = middle - root;
    Complex best = std::abs(one - mode.exponent) < std::abs(other - mode.exponent) ? one : other;
    if (mode.exponent.imag() == 0) best = best.real();
    if (std::abs(best - mode.exponent) <= near * std::abs(mode.exponent)) mode.exponent = best;
  }

  static bool alike(const ComplexMode& a, const ComplexMode& b) {
    constexpr double same = 1e-7;
    return std::abs(a.exponent - b.exponent) <= same * std::abs(a.exponent);
  }

  /// Modes of one exponent, each along an axis where that can be; and the phase of each.
  void turn_those_alike(std::vector<ComplexMode>& modes) const {
    for (std::size_t first = 0, last; first < modes.size(); first = last) {
      last = first + 1;
      if (modes[first].rigid_body) continue;
      while (last < modes.size() && alike(modes[first], modes[last])) ++last;
      Eigen::MatrixXcd shapes(modes[first].shape.size(), last - first);
      for (std::size_t k = first; k < last; ++k)
        shapes.col(static_cast<Eigen::Index>(k - first)) = modes[k].shape;
      // Solutions of one exponent need not be orthogonal, which what turns them takes them for.
      for (Eigen::Index k = 0; k < shapes.cols(); ++k) {
        for (Eigen::Index j = 0; j < k; ++j)
          shapes.col(k) -= shapes.col(j) * shapes.col(j).dot(M(shapes.col(k)));
        const double size = std::sqrt(shapes.col(k).dot(M(shapes.col(k))).real());
        if (!(size > 1e-6)) return;
        shapes.col(k) /= size;
      }
      turn_towards_axes(shapes);
      for (std::size_t k = first; k < last; ++k)
        modes[k].shape = shapes.col(static_cast<Eigen::Index>(k - first));
    }
  }

  /// The first of two neighbours that are one, counted from 1.
  std::optional<std::size_t> found_twice(const std::vector<ComplexMode>& modes) const {
    constexpr double one = 1 - 1e-6;
    for (std::size_t k = 1; k < modes.size(); ++k)
      if (!modes[k].rigid_body && alike(modes[k - 1], modes[k]) &&
          std::abs(modes[k - 1].shape.dot(M(modes[k].shape))) > one)
        return k;
    return std::nullopt;
  }

  static constexpr int beyond = 8;

  const SmallMotions& motions_;
  std::size_t count_;
  LowestModes base_;
};

}  // namespace

ComplexModes complex_modes(const SmallMotions& motions, int count) {
  return Solver(motions, count).solve();
}

}  // namespace plumb
