#pragma once

namespace plumb {

/// What three meshes tell about the finest of them.
struct GridConvergence {
  double order = -1;  ///< p; -1: the changes do not fall from mesh to mesh, and nothing is known
  double error = -1;  ///< Richardson's estimate of the finest mesh's error, ε₂₁ / (r₂₁^p − 1)
  double index = -1;  ///< safety factor · error
};

/// The standard that `grid_convergence` follows.
inline constexpr const char* grid_convergence_standard =
    "ASME V&V 20-2009, section 2-4, as in Celik et al. 2008, J. Fluids Eng. 130, 078001";

/// The grid convergence index from the change ε₂₁ > 0 between the two finest of three meshes and ε₃₂ > 0
/// between the two coarsest, with the ratios r₂₁, r₃₂ > 1 of their element lengths, which may differ:
///   p = |ln(ε₃₂/ε₂₁) + q(p)| / ln r₂₁,   q(p) = ln((r₂₁^p − s) / (r₃₂^p − s)),   s = sign(ε₃₂/ε₂₁) = 1,
/// by fixed-point iteration. The changes are distances here, in any unit; error and index have the same.
GridConvergence grid_convergence(double change21, double change32, double ratio21, double ratio32,
                                 double safety_factor);

}  // namespace plumb
