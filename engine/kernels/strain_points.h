#pragma once

#include "engine/kernels/kernels.h"
#include "engine/kernels/lanes.h"

// Strain and curvature of four elements. On an element ξ in [−1, 1], the slope is r' = e + ξ o + ξ² u with
//   e = 3/2 d − 1/4 (g₀ + g₁),  o = 1/2 (g₁ − g₀),  u = 3/4 (g₀ + g₁) − 3/2 d,  d = (r₁ − r₀)/l
// (the Hermite functions of hermite.h about the middle), and r'' = (2/l)(o + 2 ξ u). So a = r'·r' is a
// polynomial of degree 4 in ξ with coefficients from six inner products, and r' × r'' = (2/l)(A + 2ξ B + ξ²
// C) with A = e × o, B = e × u, C = o × u. What an integration point adds is then a few scalars; their
// moments Σ ξⁱ(…) are all that vectors have to be multiplied with. Points come in pairs ±ξ, of which the even
// and odd parts are shared.
namespace plumb::kernels {
namespace {

/// Below this r'·r' counts as collapsed.
inline constexpr double slope_squared_floor = slope_floor * slope_floor;

/// Integration points with ξ ≥ 0; each but 0 stands for ±ξ. Weights of a rule add up to 1 on [0, 1].
struct Rule {
  int pairs;
  double center_weight;
  double xi[2];
  double weight[2];
};

inline constexpr Rule gauss_2{1, 0, {0.57735026918962576451, 0}, {0.5, 0}};
inline constexpr Rule gauss_3{1, 8.0 / 18, {0.77459666924148337704, 0}, {5.0 / 18, 0}};
inline constexpr Rule gauss_5{2,
                              64.0 / 225,
                              {0.53846931010568309104, 0.90617984593866399280},
                              {0.23931433524968323402, 0.11846344252809454376}};
inline constexpr Rule lobatto_3{1, 4.0 / 6, {1, 0}, {1.0 / 6, 0}};

template <bool full>
inline constexpr Rule axial_rule = full ? gauss_5 : lobatto_3;
template <bool full>
inline constexpr Rule bending_rule = full ? gauss_3 : gauss_2;

/// The nodal vectors of four elements.
struct Nodes {
  Lanes3 r0, g0, r1, g1;
};

/// Coefficients of the slope, of a = r'·r' and of ½ l r' × r''.
struct Shape {
  Lanes3 e, o, u;
  Lanes a0, a1, a2, a3, a4;
  Lanes3 A, B, C;

  PLUMB_INLINE Shape(const Nodes& n, double length) {
    const Lanes3 d = (1 / length) * (n.r1 - n.r0), s = n.g0 + n.g1;
    e = 1.5 * d - 0.25 * s;
    o = 0.5 * (n.g1 - n.g0);
    u = 0.75 * s - 1.5 * d;
    a0 = dot(e, e);
    a1 = 2 * dot(e, o);
    a2 = dot(o, o) + 2 * dot(e, u);
    a3 = 2 * dot(o, u);
    a4 = dot(u, u);
    A = cross(e, o);
    B = cross(e, u);
    C = cross(o, u);
  }

  /// r'·r' at ξ = ±xi.
  PLUMB_INLINE LanesPair slope_squared(double xi) const {
    const double x2 = xi * xi;
    const Lanes even = a0 + x2 * (a2 + x2 * a4), odd = xi * (a1 + x2 * a3);
    return {even + odd, even - odd};
  }
};

/// Moments Σ ξⁱ t of a scalar t over integration points, i = 0 … 4.
struct Moments {
  Lanes m0 = {}, m1 = {}, m2 = {}, m3 = {}, m4 = {};

  PLUMB_INLINE void add_center(Lanes t) { m0 += t; }
  PLUMB_INLINE void add_pair(double xi, Lanes plus, Lanes minus) {
    const double x2 = xi * xi;
    const Lanes even = plus + minus, odd = xi * (plus - minus);
    m0 += even;
    m1 += odd;
    m2 += x2 * even;
    m3 += x2 * odd;
    m4 += (x2 * x2) * even;
  }
};

/// Axial stress over EA, and its derivative by a times 2.
template <bool green>
struct AxialStress {
  Lanes value, slope;

  PLUMB_INLINE explicit AxialStress(Lanes a) {
    if constexpr (green) {
      value = 0.5 * (a - 1);
      slope = all(1);
    } else {
      const Lanes inverse = 1 / root(larger(a, all(slope_squared_floor)));
      value = 1 - inverse;
      slope = inverse * inverse * inverse;
    }
  }
};

/// The axial strain.
template <bool green>
PLUMB_INLINE Lanes strain(Lanes a) {
  if constexpr (green)
    return 0.5 * (a - 1);
  else
    return root(a) - 1;
}

/// κ² = n·n / a^p: with W = ½ k n·n and k = stiffness / a^p, all that its derivatives by a need.
template <bool green>
struct BendingPoint {
  static constexpr double p = green ? 3 : 2;
  Lanes inverse, k, nn;

  PLUMB_INLINE BendingPoint(double stiffness, Lanes a, Lanes n_squared) : nn(n_squared) {
    inverse = 1 / larger(a, all(slope_squared_floor));
    const Lanes square = inverse * inverse;
    k = stiffness * (green ? square * inverse : square);
  }

  PLUMB_INLINE Lanes tau() const { return (-p) * (k * nn * inverse); }  // 2 ∂W/∂a
};

/// n = A + 2ξ B + ξ² C at ξ = ±xi.
struct NormalPair {
  Lanes3 plus, minus;

  PLUMB_INLINE NormalPair(const Shape& s, double xi) {
    const Lanes3 even = s.A + (xi * xi) * s.C, odd = (2 * xi) * s.B;
    plus = even + odd;
    minus = even - odd;
  }
};

/// Σ k n, Σ 2ξ k n and Σ ξ² k n: the derivatives of Σ ½ k n·n by A, B and C.
struct NormalMoments {
  Lanes3 a, b, c;
};
PLUMB_INLINE NormalMoments normal_moments(const Shape& s, const Moments& k) {
  return {k.m0 * s.A + (2 * k.m1) * s.B + k.m2 * s.C, 2 * (k.m1 * s.A + (2 * k.m2) * s.B + k.m3 * s.C),
          k.m2 * s.A + (2 * k.m3) * s.B + k.m4 * s.C};
}

}  // namespace
}  // namespace plumb::kernels
