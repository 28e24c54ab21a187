#pragma once

#include <array>

namespace plumb {

/// Cubic Hermite shape functions of the gradient-deficient cable element on x in [0, 1] with length l, for
/// the nodal vectors (r₀, r'₀, r₁, r'₁), where ' is the derivative with respect to arc length, lx:
///   s₁ = 1 − 3x² + 2x³,  s₂ = l(x − 2x² + x³),  s₃ = 3x² − 2x³,  s₄ = l(−x² + x³).
/// Recuero and Negrut (2016), eq. 2, print s₁ = 1 − 2x² + 2x³: a misprint, as a rigid translation needs s₁ +
/// s₃ = 1.
struct Hermite {
  /// s₁ … s₄ (s₂ and s₄ in m).
  static constexpr std::array<double, 4> values(double x, double l) {
    return {1 - 3 * x * x + 2 * x * x * x, l * (x - 2 * x * x + x * x * x), 3 * x * x - 2 * x * x * x,
            l * (x * x * x - x * x)};
  }

  /// First derivatives with respect to arc length (s₁' and s₃' in 1/m).
  static constexpr std::array<double, 4> slopes(double x, double l) {
    return {(6 * x * x - 6 * x) / l, 1 - 4 * x + 3 * x * x, (6 * x - 6 * x * x) / l, 3 * x * x - 2 * x};
  }

  /// Second derivatives with respect to arc length (s₁'' and s₃'' in 1/m², s₂'' and s₄'' in 1/m).
  static constexpr std::array<double, 4> curvatures(double x, double l) {
    return {(12 * x - 6) / (l * l), (6 * x - 4) / l, (6 - 12 * x) / (l * l), (6 * x - 2) / l};
  }
};

}  // namespace plumb
