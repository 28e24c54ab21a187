#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace plumb {

/// A backward differentiation formula (Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I,
/// section III.1): y(t₀) = Σ old[j] y(t₋₁₋ⱼ) + reach y'(t₀), exact for polynomials of degree `order`.
struct BdfFormula {
  static constexpr int highest_order = 5;

  int order;
  double reach;                           ///< s
  std::array<double, highest_order> old;  ///< of the values before, the last one first; pure numbers

  /// `before`: how long before t₀ the last values were, s, rising, as many as the order, 1 to 5. From the
  /// derivative at t₀ of the polynomial through all values; with equal steps it is the well-known formula.
  explicit BdfFormula(std::span<const double> before)
      : order(static_cast<int>(before.size())), reach(0), old{} {
    double own = 0;
    for (const double t : before) own += 1 / t;
    reach = 1 / own;
    for (std::size_t j = 0; j < before.size(); ++j) {
      double weight = 1 / before[j];
      for (std::size_t m = 0; m < before.size(); ++m)
        if (m != j) weight *= before[m] / (before[m] - before[j]);
      old[j] = weight / own;
    }
  }
};

}  // namespace plumb
