#include "engine/base/latin_hypercube.h"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace plumb {
namespace {

/// In (0, 1). The distributions of the standard library differ between its makers; its generators do not.
double unit_number(std::mt19937_64& random) {
  constexpr double spacing = 0x1p-53;
  return (static_cast<double>(random() >> 11) + 0.5) * spacing;
}

}  // namespace

std::vector<std::vector<double>> latin_hypercube(std::size_t samples, std::size_t dimensions,
                                                 std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> points(samples, std::vector<double>(dimensions));
  std::vector<double> column(samples);
  for (std::size_t d = 0; d < dimensions; ++d) {
    for (std::size_t k = 0; k < samples; ++k)
      column[k] = (static_cast<double>(k) + unit_number(random)) / static_cast<double>(samples);
    for (std::size_t k = samples; k > 1; --k)
      std::swap(column[k - 1],
                column[static_cast<std::size_t>(unit_number(random) * static_cast<double>(k))]);
    for (std::size_t k = 0; k < samples; ++k) points[k][d] = column[k];
  }
  return points;
}

double normal_quantile(double p) {
  if (p > 0.5) return -normal_quantile(1 - p);
  constexpr int most_iterations = 100;
  // Newton's method for the logarithm of the distribution function, which is concave, so that from below all
  // steps go up to the solution. The start is below it, as Φ(−y) ≤ exp(−y²/2)/2.
  double x = -std::sqrt(-2 * std::log(2 * p));
  for (int k = 0; k < most_iterations; ++k) {
    const double below = 0.5 * std::erfc(-x / std::numbers::sqrt2);
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi);
    const double step = below * std::log(below / p) / density;
    x -= step;
    if (std::abs(step) <= 1e-15 * std::abs(x)) break;
  }
  return x;
}

}  // namespace plumb
