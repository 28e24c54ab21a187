#pragma once

#include <Eigen/Core>
#include <optional>

namespace plumb {

class Cable;

/// How a straight cable gives way first under its loads.
struct Buckling {
  double load = 0;        ///< as a multiple of the loads, > 0
  Eigen::VectorXd shape;  ///< of the nodal coordinates; its greatest displacement is 1 m
};

/// Greatest multiple of the loads at which buckling is sought.
inline constexpr double greatest_buckling_load = 1e4;

/// The first buckling load and mode of a cable that is straight and unstretched at q, by linearisation:
/// (K₀ + λ dK/dλ) φ = 0, where q + λ K₀⁻¹ F is the way it goes along itself under the loads F. Of two modes
/// alike, the one that moves most along y, else z, else x, and to its positive side there. Nothing where no
/// multiple of the loads up to greatest_buckling_load presses it enough, or nothing holds the cable.
std::optional<Buckling> first_buckling(const Cable& cable, const Eigen::VectorXd& q);

}  // namespace plumb
