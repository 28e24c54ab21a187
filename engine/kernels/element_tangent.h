#pragma once

#include "engine/kernels/strain_points.h"

namespace plumb::kernels {
namespace {

/// A 3 by 3 block for each lane, by columns: entry (row, column) is at [3 column + row].
struct Block3 {
  Lanes at[9];
};

PLUMB_INLINE Block3 operator+(const Block3& a, const Block3& b) {
  Block3 sum;
  for (int i = 0; i < 9; ++i) sum.at[i] = a.at[i] + b.at[i];
  return sum;
}
PLUMB_INLINE Block3 operator-(const Block3& a, const Block3& b) {
  Block3 difference;
  for (int i = 0; i < 9; ++i) difference.at[i] = a.at[i] - b.at[i];
  return difference;
}
PLUMB_INLINE Block3 operator*(double s, const Block3& a) {
  Block3 product;
  for (int i = 0; i < 9; ++i) product.at[i] = s * a.at[i];
  return product;
}
PLUMB_INLINE Block3 transposed(const Block3& a) {
  return {{a.at[0], a.at[3], a.at[6], a.at[1], a.at[4], a.at[7], a.at[2], a.at[5], a.at[8]}};
}
/// A symmetric block: xx, yx, zx, yy, zy, zz.
struct Symmetric3 {
  Lanes at[6];

  PLUMB_INLINE Block3 full() const {
    return {{at[0], at[1], at[2], at[1], at[3], at[4], at[2], at[4], at[5]}};
  }
  PLUMB_INLINE void add_identity(Lanes s) {
    at[0] += s;
    at[3] += s;
    at[5] += s;
  }
};
PLUMB_INLINE Symmetric3 operator+(const Symmetric3& a, const Symmetric3& b) {
  Symmetric3 sum;
  for (int i = 0; i < 6; ++i) sum.at[i] = a.at[i] + b.at[i];
  return sum;
}
PLUMB_INLINE Symmetric3 operator-(const Symmetric3& a, const Symmetric3& b) {
  Symmetric3 difference;
  for (int i = 0; i < 6; ++i) difference.at[i] = a.at[i] - b.at[i];
  return difference;
}
PLUMB_INLINE Symmetric3 operator*(double s, const Symmetric3& a) {
  Symmetric3 product;
  for (int i = 0; i < 6; ++i) product.at[i] = s * a.at[i];
  return product;
}
/// B + Bᵀ.
PLUMB_INLINE Symmetric3 twice_symmetric_part(const Block3& b) {
  return {{2 * b.at[0], b.at[1] + b.at[3], b.at[2] + b.at[6], 2 * b.at[4], b.at[5] + b.at[7], 2 * b.at[8]}};
}

/// a bᵀ + c dᵀ, rows from a and c.
PLUMB_INLINE Block3 dyads(const Lanes3& a, const Lanes3& b, const Lanes3& c, const Lanes3& d) {
  return {{a.x * b.x + c.x * d.x, a.y * b.x + c.y * d.x, a.z * b.x + c.z * d.x, a.x * b.y + c.x * d.y,
           a.y * b.y + c.y * d.y, a.z * b.y + c.z * d.y, a.x * b.z + c.x * d.z, a.y * b.z + c.y * d.z,
           a.z * b.z + c.z * d.z}};
}
/// a bᵀ + c dᵀ, known to be symmetric.
PLUMB_INLINE Symmetric3 symmetric_dyads(const Lanes3& a, const Lanes3& b, const Lanes3& c, const Lanes3& d) {
  return {{a.x * b.x + c.x * d.x, a.y * b.x + c.y * d.x, a.z * b.x + c.z * d.x, a.y * b.y + c.y * d.y,
           a.z * b.y + c.z * d.y, a.z * b.z + c.z * d.z}};
}
/// a bᵀ + b aᵀ.
PLUMB_INLINE Symmetric3 symmetric_product(const Lanes3& a, const Lanes3& b) {
  return symmetric_dyads(a, b, b, a);
}
PLUMB_INLINE Block3 dyad(const Lanes3& a, const Lanes3& b) {
  return {
      {a.x * b.x, a.y * b.x, a.z * b.x, a.x * b.y, a.y * b.y, a.z * b.y, a.x * b.z, a.y * b.z, a.z * b.z}};
}
/// block −= [v]ₓ, the matrix of the cross product with v.
PLUMB_INLINE void subtract_cross(Block3& block, const Lanes3& v) {
  block.at[1] -= v.z;
  block.at[2] += v.y;
  block.at[3] += v.z;
  block.at[5] -= v.x;
  block.at[6] -= v.y;
  block.at[7] += v.x;
}

/// Moments Σ ξⁱ S of a symmetric block, i = 0 … 4.
struct SymmetricMoments {
  Symmetric3 m[5];

  PLUMB_INLINE void add_pair(double xi, const Symmetric3& plus, const Symmetric3& minus) {
    const double x2 = xi * xi;
    for (int i = 0; i < 6; ++i) {
      const Lanes even = plus.at[i] + minus.at[i], odd = xi * (plus.at[i] - minus.at[i]);
      m[0].at[i] += even;
      m[1].at[i] += odd;
      m[2].at[i] += x2 * even;
      m[3].at[i] += x2 * odd;
      m[4].at[i] += (x2 * x2) * even;
    }
  }
};

/// ∂²U/∂q² of four elements in the vectors (r₀, g₀, r₁, g₁); r₁ enters as −r₀ does, so that six blocks hold
/// all. Rows first: d is the row of r₁ (that of r₀ is −d).
struct Tangents {
  Symmetric3 dd, g0g0, g1g1;
  Block3 dg0, dg1, g1g0;
};

/// The second derivatives of ∫ ½EA ε² + ½EI κ² dx by e, o and u, brought back to the nodal vectors. With g =
/// r' and n = g × c at a point, c = o + 2ξ u, the derivatives by zᵢ = e, o, u are ∂a = 2ξⁱ g and ∂(½n·n) = hᵢ
/// × n with hᵢ = ξⁱ c − i ξ^(i−1) g, so that block (i, j) is
///   Σ ξ^(i+j) (τ I + 2 τ' g gᵀ) + k ((hᵢ·hⱼ) I − hⱼ hᵢᵀ − (j − i) ξ^(i+j−1) [n]ₓ)
///     − 2p k/a (ξⁱ g (hⱼ × n)ᵀ + (hᵢ × n) ξʲ gᵀ).
template <bool green, bool full>
PLUMB_INLINE Tangents element_tangent(const ElementConstants& c, const Nodes& nodes) {
  const Shape s(nodes, c.length);
  const double EA = c.axial_stiffness * c.length, EI = c.bending_stiffness * 4 / c.length;
  constexpr double p = green ? 3 : 2;
  const Lanes3 &e = s.e, &o = s.o, &u = s.u;

  Moments t, k;
  SymmetricMoments S = {};  // of 2 τ' g gᵀ and the symmetric part of the mixed term
  Block3 Y0, Y1, Y2, Y3;    // Σ ξⁱ (−2p k/a) g (n × g)ᵀ

  struct Bending {
    BendingPoint<green> point;
    Symmetric3 sym;
    Block3 y;
    PLUMB_INLINE Bending(double weight, Lanes a, const Lanes3& slope, const Lanes3& bend, const Lanes3& n)
        : point(weight, a, dot(n, n)) {
      const Lanes mixed = (-2 * p) * (point.k * point.inverse);
      const Lanes half = (p * (p + 1)) * (point.k * point.nn * point.inverse * point.inverse);
      sym = symmetric_product(slope, half * slope + mixed * cross(bend, n));
      y = dyad(slope, mixed * cross(n, slope));
    }
  };

  constexpr Rule axial = axial_rule<full>;
  {
    const AxialStress<green> stress(s.a0);
    const double weight = axial.center_weight * EA;
    t.add_center(weight * stress.value);
    const Lanes3 scaled = (0.5 * weight * stress.slope) * e;
    S.m[0] = symmetric_product(e, scaled);
  }
  for (int i = 0; i < axial.pairs; ++i) {
    const double xi = axial.xi[i], weight = axial.weight[i] * EA;
    const LanesPair a = s.slope_squared(xi);
    const AxialStress<green> plus(a.first), minus(a.second);
    t.add_pair(xi, weight * plus.value, weight * minus.value);
    const Lanes3 even = e + (xi * xi) * u, odd = xi * o, gp = even + odd, gm = even - odd;
    const auto product = [&](const Lanes3& g, Lanes slope) {
      const Lanes3 w = (weight * slope) * g;
      return Symmetric3{{w.x * g.x, w.y * g.x, w.z * g.x, w.y * g.y, w.z * g.y, w.z * g.z}};
    };
    S.add_pair(xi, product(gp, plus.slope), product(gm, minus.slope));
  }

  constexpr Rule rule = bending_rule<full>;
  if constexpr (rule.center_weight > 0) {
    const Bending at(rule.center_weight * EI, s.a0, e, o, s.A);
    k.add_center(at.point.k);
    t.add_center(at.point.tau());
    S.m[0] = S.m[0] + at.sym;
    Y0 = at.y;
  } else {
    Y0 = {};
  }
  static_assert(rule.pairs == 1);
  {
    const double xi = rule.xi[0], weight = rule.weight[0] * EI;
    const LanesPair a = s.slope_squared(xi);
    const NormalPair n(s, xi);
    const Lanes3 even = e + (xi * xi) * u, odd = xi * o, turn = (2 * xi) * u;
    const Bending plus(weight, a.first, even + odd, o + turn, n.plus);
    const Bending minus(weight, a.second, even - odd, o - turn, n.minus);
    k.add_pair(xi, plus.point.k, minus.point.k);
    t.add_pair(xi, plus.point.tau(), minus.point.tau());
    S.add_pair(xi, plus.sym, minus.sym);
    const Block3 sum = plus.y + minus.y;
    Y1 = xi * (plus.y - minus.y);
    Y0 = Y0 + sum;
    Y2 = (xi * xi) * sum;
    Y3 = (xi * xi) * Y1;
  }

  const auto [a, b, m] = normal_moments(s, k);

  // −hⱼ hᵢᵀ summed, from products of the coefficient vectors.
  const Lanes3 o0 = k.m0 * o + (2 * k.m1) * u, o1 = (2 * k.m1) * o + (4 * k.m2) * u;
  const Lanes3 o2 = k.m2 * o + (2 * k.m3) * u;
  const Lanes3 e1 = k.m2 * u - k.m0 * e, e2 = k.m4 * u - k.m2 * e;
  const Lanes3 v0 = (4 * k.m2) * e + (2 * k.m3) * o, v1 = (2 * k.m3) * e + k.m4 * o;
  const Lanes3 w1 = (2 * k.m3) * u - (2 * k.m1) * e;

  Symmetric3 H00 = S.m[0] - symmetric_dyads(o, o0, u, o1);
  Symmetric3 H11 = S.m[2] + twice_symmetric_part(Y1) - symmetric_dyads(u, e2, -1.0 * e, e1);
  Symmetric3 H22 = S.m[4] + 2 * twice_symmetric_part(Y3) - symmetric_dyads(e, v0, o, v1);
  Block3 H01 = S.m[1].full() + Y0 + dyads(e, o0, -1.0 * u, o2);
  Block3 H02 = S.m[2].full() + 2 * Y1 + dyads(e, o1, o, o2);
  Block3 H12 = S.m[3].full() + 2 * Y2 + transposed(Y2) + dyads(e, w1, o, e2);
  subtract_cross(H01, a);
  subtract_cross(H02, b);
  subtract_cross(H12, m);

  // τ and hᵢ·hⱼ on the diagonals.
  H00.add_identity(t.m0 + dot(o, o0) + dot(u, o1));
  H11.add_identity(t.m2 + dot(u, e2) - dot(e, e1));
  H22.add_identity(t.m4 + dot(e, v0) + dot(o, v1));
  const auto add_identity = [](Block3& block, Lanes value) {
    block.at[0] += value;
    block.at[4] += value;
    block.at[8] += value;
  };
  add_identity(H01, t.m1 - dot(e, o0) + dot(u, o2));
  add_identity(H02, t.m2 - dot(e, o1) - dot(o, o2));
  add_identity(H12, t.m3 - dot(e, w1) - dot(o, e2));

  // e = 3/2 d − 1/4 s, u = 3/4 s − 3/2 d, o = 1/2 (g₁ − g₀) with s = g₀ + g₁; d = (r₁ − r₀)/l.
  const double per_length = 1 / c.length;
  const Symmetric3 both02 = twice_symmetric_part(H02);
  const Block3 H20 = transposed(H02), H21 = transposed(H12);
  const Symmetric3 ss = 0.0625 * H00 - 0.1875 * both02 + 0.5625 * H22;
  const Symmetric3 hh = 0.25 * H11, even = ss + hh, between = ss - hh;
  const Block3 sh = 0.375 * H21 - 0.125 * H01;
  const Symmetric3 both = twice_symmetric_part(sh);
  const Block3 ds = (1.5 * per_length) * (0.75 * H02 + 0.25 * H20 - (0.25 * H00 + 0.75 * H22).full());
  const Block3 dh = (0.75 * per_length) * (H01 - H21);
  return {(2.25 * per_length * per_length) * (H00 + H22 - both02),
          even - both,
          even + both,
          ds - dh,
          ds + dh,
          between.full() + transposed(sh) - sh};
}

}  // namespace
}  // namespace plumb::kernels
