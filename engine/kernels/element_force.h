#pragma once

#include "engine/kernels/strain_points.h"

namespace plumb::kernels {
namespace {

/// The force on all mass − ∂U/∂q of four elements, and whether the slope is above its floor at every
/// integration point.
struct Forces {
  Lanes3 r0, g0, r1, g1;
  Mask sound;
};

template <bool green, bool full>
PLUMB_INLINE Forces element_force(const ElementConstants& c, const Nodes& nodes) {
  const Shape s(nodes, c.length);
  const double EA = c.axial_stiffness * c.length, EI = c.bending_stiffness * 4 / c.length;
  Moments t, k;  // of 2 ∂U/∂a and of the k of bending
  const Lanes floor = all(slope_squared_floor);
  Mask sound = s.a0 > floor;

  constexpr Rule axial = axial_rule<full>;
  t.add_center((axial.center_weight * EA) * AxialStress<green>(s.a0).value);
  for (int i = 0; i < axial.pairs; ++i) {
    const LanesPair a = s.slope_squared(axial.xi[i]);
    sound &= (a.first > floor) & (a.second > floor);
    const double weight = axial.weight[i] * EA;
    t.add_pair(axial.xi[i], weight * AxialStress<green>(a.first).value,
               weight * AxialStress<green>(a.second).value);
  }

  constexpr Rule bending = bending_rule<full>;
  if constexpr (bending.center_weight > 0) {
    const BendingPoint<green> at(bending.center_weight * EI, s.a0, dot(s.A, s.A));
    k.add_center(at.k);
    t.add_center(at.tau());
  }
  for (int i = 0; i < bending.pairs; ++i) {
    const LanesPair a = s.slope_squared(bending.xi[i]);
    sound &= (a.first > floor) & (a.second > floor);
    const NormalPair n(s, bending.xi[i]);
    const double weight = bending.weight[i] * EI;
    const BendingPoint<green> plus(weight, a.first, dot(n.plus, n.plus));
    const BendingPoint<green> minus(weight, a.second, dot(n.minus, n.minus));
    k.add_pair(bending.xi[i], plus.k, minus.k);
    t.add_pair(bending.xi[i], plus.tau(), minus.tau());
  }

  const auto [a, b, m] = normal_moments(s, k);
  const Lanes3 de = t.m0 * s.e + t.m1 * s.o + t.m2 * s.u + cross(s.o, a) + cross(s.u, b);
  const Lanes3 dd = t.m1 * s.e + t.m2 * s.o + t.m3 * s.u + cross(a, s.e) + cross(s.u, m);
  const Lanes3 du = t.m2 * s.e + t.m3 * s.o + t.m4 * s.u + cross(b, s.e) + cross(m, s.o);

  const Lanes3 pull = (1.5 / c.length) * (de - du), even = 0.25 * de - 0.75 * du, odd = 0.5 * dd;
  // ∫ ρA sᵢ dx: half of the mass at either end, and ± a twelfth times l for the slopes.
  const double half = 0.5 * c.mass_per_length * c.length, twelfth = half * c.length / 6;
  const Lanes3 weight{all(half * c.per_mass[0]), all(half * c.per_mass[1]), all(half * c.per_mass[2])};
  const Lanes3 turn{all(twelfth * c.per_mass[0]), all(twelfth * c.per_mass[1]), all(twelfth * c.per_mass[2])};
  return {weight + pull, even + odd + turn, weight - pull, even - odd - turn, sound};
}

template <bool green, bool full>
PLUMB_INLINE LanesPair element_energy(const ElementConstants& c, const Nodes& nodes) {
  const Shape s(nodes, c.length);
  const double EA = 0.5 * c.axial_stiffness * c.length, EI = 0.5 * c.bending_stiffness * 4 / c.length;
  const auto axial_at = [&](Lanes a) {
    const Lanes epsilon = strain<green>(a);
    return epsilon * epsilon;
  };
  const auto bending_at = [&](double weight, Lanes a, const Lanes3& n) {
    const BendingPoint<green> at(weight, a, dot(n, n));
    return at.k * at.nn;
  };
  constexpr Rule axial = axial_rule<full>;
  Lanes stretching = axial.center_weight * axial_at(s.a0);
  for (int i = 0; i < axial.pairs; ++i) {
    const LanesPair a = s.slope_squared(axial.xi[i]);
    stretching += axial.weight[i] * (axial_at(a.first) + axial_at(a.second));
  }
  constexpr Rule rule = bending_rule<full>;
  Lanes bending = {};
  if constexpr (rule.center_weight > 0) bending += bending_at(rule.center_weight * EI, s.a0, s.A);
  for (int i = 0; i < rule.pairs; ++i) {
    const LanesPair a = s.slope_squared(rule.xi[i]);
    const NormalPair n(s, rule.xi[i]);
    bending +=
        bending_at(rule.weight[i] * EI, a.first, n.plus) + bending_at(rule.weight[i] * EI, a.second, n.minus);
  }
  return {EA * stretching, bending};
}

}  // namespace
}  // namespace plumb::kernels
