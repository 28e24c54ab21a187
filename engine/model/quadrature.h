#pragma once

#include <span>

namespace plumb {

/// An integration point on x in [0, 1]; the weights of a rule add up to 1.
struct QuadraturePoint {
  double x;
  double weight;
};

/// Gauss-Legendre rule with 2, 3 or 5 points, exact for polynomials of degree 2·points − 1.
/// Throws std::invalid_argument for another number of points.
std::span<const QuadraturePoint> gauss_rule(int points);

/// Lobatto rule with 3 points (Simpson's), exact for polynomials of degree 3.
std::span<const QuadraturePoint> lobatto_rule();

/// The rules of full and of reduced quadrature for the energy of stretching and for that of bending.
std::span<const QuadraturePoint> stretching_rule(bool full);
std::span<const QuadraturePoint> bending_rule(bool full);

}  // namespace plumb
