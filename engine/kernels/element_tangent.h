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
/// A symmetric block: xx, yx, zx, yy, zy, zz.
struct Symmetric3 {
  Lanes at[6];
};
/// Where the entry (i, j) of a symmetric block is.
constexpr int symmetric_place(int i, int j) {
  return i > j ? j * (5 - j) / 2 + i : i * (5 - i) / 2 + j;
}
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
/// s a aᵀ.
PLUMB_INLINE Symmetric3 square(Lanes s, const Lanes3& a) {
  const Lanes3 b = s * a;
  return {{b.x * a.x, b.y * a.x, b.z * a.x, b.y * a.y, b.z * a.y, b.z * a.z}};
}
/// a bᵀ + b aᵀ.
PLUMB_INLINE Symmetric3 symmetric_product(const Lanes3& a, const Lanes3& b) {
  return {{a.x * b.x + b.x * a.x, a.y * b.x + b.y * a.x, a.z * b.x + b.z * a.x, a.y * b.y + b.y * a.y,
           a.z * b.y + b.z * a.y, a.z * b.z + b.z * a.z}};
}
/// a bᵀ.
PLUMB_INLINE Block3 dyad(const Lanes3& a, const Lanes3& b) {
  return {
      {a.x * b.x, a.y * b.x, a.z * b.x, a.x * b.y, a.y * b.y, a.z * b.y, a.x * b.z, a.y * b.z, a.z * b.z}};
}

PLUMB_INLINE Lanes entry(const Lanes3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

/// The share of the vectors (d, s, h) in the slope at ξ, r' = p d + q s + r h with d = (r₁ − r₀)/l, s = g₀ +
/// g₁ and h = g₁ − g₀, and their derivatives by ξ.
struct Shares {
  double p, q, r;
  double dp, dq, dr;

  constexpr explicit Shares(double xi)
      : p(1.5 * (1 - xi * xi)), q(0.75 * xi * xi - 0.25), r(0.5 * xi), dp(-3 * xi), dq(1.5 * xi), dr(0.5) {}
};

/// Sum and difference of what belongs to ±ξ.
template <class Block>
struct Parts {
  Block even, odd;

  PLUMB_INLINE void set(const Block& plus, const Block& minus) {
    even = plus + minus;
    odd = plus - minus;
  }
};

/// ∂²U/∂q² of four elements in the vectors (r₀, g₀, r₁, g₁); r₁ enters as −r₀ does, so that six blocks hold
/// all. Rows first: d is the row of r₁ (that of r₀ is −d).
struct Tangents {
  Symmetric3 dd, g0g0, g1g1;
  Block3 dg0, dg1, g1g0;
};

/// The second derivatives of ∫ ½EA ε² + ½EI κ² dx by z = (d, s, h) of Shares, from which only signs lead to
/// those by the nodal vectors. With g = r' and n = g × c at a point, c = ∂g/∂ξ and the shares φ = (p, q, r),
/// the derivatives by zᵢ are ∂a = 2 φᵢ g and ∂(½n·n) = hᵢ × n with
///   hᵢ = φᵢ c − φᵢ' g = Σⱼ wᵢⱼ zⱼ,   wᵢⱼ = φᵢ φⱼ' − φᵢ' φⱼ,
/// so that block (i, j) is
///   Σ φᵢφⱼ (τ I + 2 τ' g gᵀ) + k ((hᵢ·hⱼ) I − hⱼ hᵢᵀ − wᵢⱼ [n]ₓ) + φᵢφⱼ (g mᵀ + m gᵀ) + φᵢφⱼ' Y + φᵢ'φⱼ Yᵀ
/// with m = (−2p k/a) c × n and Y = (−2p k/a) g (n × g)ᵀ. The w are w_ds = 3/2 ξ, w_dh = 3/4 (1 + ξ²) and
/// w_sh = −1/8 (1 + 3ξ²).
template <bool green, bool full>
PLUMB_INLINE Tangents element_tangent(const ElementConstants& constants, const Nodes& nodes) {
  const Shape shape(nodes, constants.length);
  const double EA = constants.axial_stiffness * constants.length,
               EI = constants.bending_stiffness * 4 / constants.length;
  constexpr double p = green ? 3 : 2;
  const Lanes3 &e = shape.e, &o = shape.o, &u = shape.u;

  struct Bending {
    BendingPoint<green> point;
    Symmetric3 symmetric;
    Block3 y;
    PLUMB_INLINE Bending(double weight, Lanes a, const Lanes3& g, const Lanes3& c, const Lanes3& n)
        : point(weight, a, dot(n, n)) {
      const Lanes mixed = (-2 * p) * (point.k * point.inverse);
      const Lanes half = (p * (p + 1)) * (point.k * point.nn * point.inverse * point.inverse);
      symmetric = symmetric_product(g, half * g + mixed * cross(c, n));
      y = dyad(g, mixed * cross(n, g));
    }
  };

  // What is symmetric, at ξ = 0 and for each pair of points, the one of bending first.
  constexpr Rule axial = axial_rule<full>, bending = bending_rule<full>;
  static_assert(bending.pairs == 1);
  constexpr int pairs = 1 + axial.pairs;
  constexpr Shares at[] = {Shares(bending.xi[0]), Shares(axial.xi[0]), Shares(axial.xi[1])}, middle(0);
  Symmetric3 center;
  Parts<Symmetric3> symmetric[pairs];
  Block3 center_y = {};
  Parts<Block3> y;
  Moments t, k;

  {
    const double weight = axial.center_weight * EA;
    const AxialStress<green> stress(shape.a0);
    t.add_center(weight * stress.value);
    center = square(weight * stress.slope, e);
  }
  for (int i = 0; i < axial.pairs; ++i) {
    const double xi = axial.xi[i], weight = axial.weight[i] * EA;
    const LanesPair a = shape.slope_squared(xi);
    const AxialStress<green> plus(a.first), minus(a.second);
    t.add_pair(xi, weight * plus.value, weight * minus.value);
    const Lanes3 even = e + (xi * xi) * u, odd = xi * o;
    symmetric[1 + i].set(square(weight * plus.slope, even + odd), square(weight * minus.slope, even - odd));
  }
  if constexpr (bending.center_weight > 0) {
    const Bending point(bending.center_weight * EI, shape.a0, e, o, shape.A);
    k.add_center(point.point.k);
    t.add_center(point.point.tau());
    center = center + point.symmetric;
    center_y = point.y;
  }
  {
    const double xi = bending.xi[0], weight = bending.weight[0] * EI;
    const LanesPair a = shape.slope_squared(xi);
    const NormalPair n(shape, xi);
    const Lanes3 even = e + (xi * xi) * u, odd = xi * o, turn = (2 * xi) * u;
    const Bending plus(weight, a.first, even + odd, o + turn, n.plus);
    const Bending minus(weight, a.second, even - odd, o - turn, n.minus);
    k.add_pair(xi, plus.point.k, minus.point.k);
    t.add_pair(xi, plus.point.tau(), minus.point.tau());
    symmetric[0].set(plus.symmetric, minus.symmetric);
    y.set(plus.y, minus.y);
  }

  // Σ k wᵢⱼ [n] of (d, s), (d, h) and (h, s).
  const NormalMoments n = normal_moments(shape, k);
  const Lanes3 turn_ds = 0.75 * n.b, turn_dh = 0.75 * (n.a + n.c), turn_hs = 0.125 * (n.a + 3 * n.c);

  // Σ k of the products of 3/2 ξ, 3/4 (1 + ξ²) and 1/8 (1 + 3ξ²), and the vectors of which hⱼ hᵢᵀ are made.
  const Lanes k11 = 2.25 * k.m2, k12 = 1.125 * (k.m1 + k.m3), k13 = 0.1875 * (k.m1 + 3 * k.m3);
  const Lanes k22 = 0.5625 * (k.m0 + 2 * k.m2 + k.m4), k23 = 0.09375 * (k.m0 + 4 * k.m2 + 3 * k.m4);
  const Lanes k33 = 0.015625 * (k.m0 + 6 * k.m2 + 9 * k.m4);
  const Lanes3 d = (1 / constants.length) * (nodes.r1 - nodes.r0), s = nodes.g0 + nodes.g1,
               h = nodes.g1 - nodes.g0;
  const Lanes3 s1h2 = k11 * s + k12 * h, s2h2 = k12 * s + k22 * h, s3h2 = k13 * s + k23 * h;
  const Lanes3 d1h3 = k11 * d + k13 * h, d3h3 = k13 * d + k33 * h, d2h3 = k12 * d + k23 * h;
  const Lanes3 d2s3 = k22 * d - k23 * s, s3d2 = k33 * s - k23 * d;

  // τ and hᵢ·hⱼ on the diagonals.
  const Lanes i_dd = 2.25 * (t.m0 - 2 * t.m2 + t.m4) + dot(s, s1h2) + dot(h, s2h2);
  const Lanes i_ss = 0.0625 * (t.m0 - 6 * t.m2 + 9 * t.m4) + dot(d, d1h3) + dot(h, d3h3);
  const Lanes i_hh = 0.25 * t.m2 + dot(d, d2s3) + dot(s, s3d2);
  const Lanes i_ds = 0.375 * (4 * t.m2 - t.m0 - 3 * t.m4) - dot(d, s1h2) - dot(h, s3h2);
  const Lanes i_dh = 0.75 * (t.m1 - t.m3) - dot(d, s2h2) + dot(s, s3h2);
  const Lanes i_sh = 0.125 * (3 * t.m3 - t.m1) + dot(d, d2h3) - dot(s, d3h3);

  // All blocks entry by entry, so that little has to be at hand at a time.
  const double per_length = 1 / constants.length;
  Tangents result;
#pragma GCC unroll 3
  for (int column = 0; column < 3; ++column)
#pragma GCC unroll 3
    for (int row = column; row < 3; ++row) {
      const int at_symmetric = symmetric_place(row, column), below = 3 * column + row,
                above = 3 * row + column;
      const bool diagonal = row == column;
      const auto of_even = [&](auto product) __attribute__((always_inline)) {
        Lanes sum = product(at[0]) * symmetric[0].even.at[at_symmetric];
#pragma GCC unroll 3
        for (int i = 1; i < pairs; ++i) sum += product(at[i]) * symmetric[i].even.at[at_symmetric];
        return product(middle) != 0 ? sum + product(middle) * center.at[at_symmetric] : sum;
      };
      const auto of_odd = [&](auto product) __attribute__((always_inline)) {
        Lanes sum = product(at[0]) * symmetric[0].odd.at[at_symmetric];
#pragma GCC unroll 3
        for (int i = 1; i < pairs; ++i) sum += product(at[i]) * symmetric[i].odd.at[at_symmetric];
        return sum;
      };
      constexpr Shares b = at[0];
      const Lanes both_y = y.odd.at[below] + y.odd.at[above];
      Lanes dd = of_even([](const Shares& x) { return x.p * x.p; }) + (b.p * b.dp) * both_y -
                 (entry(s, row) * entry(s1h2, column) + entry(h, row) * entry(s2h2, column));
      Lanes ss = of_even([](const Shares& x) { return x.q * x.q; }) + (b.q * b.dq) * both_y -
                 (entry(d, row) * entry(d1h3, column) + entry(h, row) * entry(d3h3, column));
      Lanes hh = of_even([](const Shares& x) { return x.r * x.r; }) + (b.r * b.dr) * both_y -
                 (entry(d, row) * entry(d2s3, column) + entry(s, row) * entry(s3d2, column));
      if (diagonal) {
        dd += i_dd;
        ss += i_ss;
        hh += i_hh;
      }
      // The others at (row, column) and at (column, row).
      const Lanes same_ds = of_even([](const Shares& x) { return x.p * x.q; });
      const Lanes same_dh = of_odd([](const Shares& x) { return x.p * x.r; });
      const Lanes same_sh = of_odd([](const Shares& x) { return x.q * x.r; });
      Lanes ds[2], dh[2], sh[2];
      for (int i = 0; i < (diagonal ? 1 : 2); ++i) {
        const int r = i == 0 ? row : column, c = i == 0 ? column : row;
        const int here = i == 0 ? below : above, there = i == 0 ? above : below;
        ds[i] = same_ds + (b.p * b.dq) * y.odd.at[here] + (b.q * b.dp) * y.odd.at[there] +
                (entry(d, r) * entry(s1h2, c) + entry(h, r) * entry(s3h2, c));
        dh[i] = same_dh + (b.p * b.dr) * y.even.at[here] + (b.r * b.dp) * y.even.at[there] +
                (entry(d, r) * entry(s2h2, c) - entry(s, r) * entry(s3h2, c));
        sh[i] = same_sh + (b.q * b.dr) * y.even.at[here] + (b.r * b.dq) * y.even.at[there] +
                (entry(s, r) * entry(d3h3, c) - entry(d, r) * entry(d2h3, c));
        if constexpr (bending.center_weight > 0) {
          dh[i] += (middle.p * middle.dr) * center_y.at[here];
          sh[i] += (middle.q * middle.dr) * center_y.at[here];
        }
      }
      if (diagonal) {
        ds[0] += i_ds;
        dh[0] += i_dh;
        sh[0] += i_sh;
        ds[1] = ds[0];
        dh[1] = dh[0];
        sh[1] = sh[0];
      } else {
        const int axis = 3 - row - column, lower = row - column == 2 ? 0 : 1, upper = 1 - lower;
        ds[lower] += entry(turn_ds, axis);
        ds[upper] -= entry(turn_ds, axis);
        dh[lower] += entry(turn_dh, axis);
        dh[upper] -= entry(turn_dh, axis);
        sh[lower] -= entry(turn_hs, axis);
        sh[upper] += entry(turn_hs, axis);
      }

      const Lanes even = ss + hh, between = ss - hh, twice = sh[0] + sh[1], turned = sh[0] - sh[1];
      result.dd.at[at_symmetric] = (per_length * per_length) * dd;
      result.g0g0.at[at_symmetric] = even - twice;
      result.g1g1.at[at_symmetric] = even + twice;
      result.dg0.at[below] = per_length * (ds[0] - dh[0]);
      result.dg1.at[below] = per_length * (ds[0] + dh[0]);
      result.g1g0.at[below] = diagonal ? between : between - turned;
      if (!diagonal) {
        result.dg0.at[above] = per_length * (ds[1] - dh[1]);
        result.dg1.at[above] = per_length * (ds[1] + dh[1]);
        result.g1g0.at[above] = between + turned;
      }
    }
  return result;
}

}  // namespace
}  // namespace plumb::kernels
