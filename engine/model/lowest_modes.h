#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "engine/model/small_motions.h"

namespace plumb {

/// Modes of K φ = ω² M φ, without the rates' part of small motions and with the symmetric part of K.
struct LowestModes {
  Eigen::VectorXd squares;  ///< ω², 1/s², rising but for the rigid-body motions, which come first with 0
  Eigen::MatrixXd shapes;   ///< φ, a column each, with φᵢᵀ M φⱼ = δᵢⱼ
  int rigid_body = 0;       ///< how many are rigid-body motions
  int negative = 0;         ///< ω² below 0, of all that there are
  std::string failure;      ///< why there are not as many as were asked for; empty: there are
};

/// At least `count` modes of the lowest ω², or all that there are: by Lanczos's method in blocks on (K + σ
/// M)⁻¹ M (Parlett 1998, section 13.10; Golub and Underwood 1977), as modes in two planes come in pairs which
/// single vectors may miss. That none was is proved by counting the eigenvalues below the last of them. ω²
/// are those of the strains (StrainStiffness), as the entries of K cancel on fine meshes. Time and memory are
/// linear in the number of elements. Throws Interrupted.
LowestModes lowest_modes(const SmallMotions& motions, int count);

}  // namespace plumb
