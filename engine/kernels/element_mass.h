#pragma once

#include "engine/kernels/kernels.h"

namespace plumb {

/// ∫ ρA sᵢsⱼ dx of the Hermite functions for the nodal vectors (r₀, g₀, r₁, g₁), exact, kg, kg m and kg m².
/// Lumped, half of the mass is at either end; slopes move none of it, and theirs only keeps the matrix
/// regular. By symmetry r₁r₁ is r₀r₀ and g₁g₁ is g₀g₀, g₁r₁ is −g₀r₀ and r₁g₀ is −g₁r₀.
struct ElementMass {
  double rr, rg, gg, r1r0, g1r0, g1g0;

  /// Always inlined: the kernels are built for other instruction sets than the rest.
  [[gnu::always_inline]] explicit ElementMass(const ElementConstants& c) {
    const double l = c.length, unit = c.mass_per_length * l / 420;
    rr = c.lumped ? 210 * unit : 156 * unit;
    rg = c.lumped ? 0 : 22 * l * unit;
    gg = 4 * l * l * unit;
    r1r0 = c.lumped ? 0 : 54 * unit;
    g1r0 = c.lumped ? 0 : -13 * l * unit;
    g1g0 = c.lumped ? 0 : -3 * l * l * unit;
  }
};

}  // namespace plumb
