#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

namespace plumb {

/// What a mode does that was set going.
enum class ModeKind {
  vibration,   ///< goes to and fro, with or without damping
  overdamped,  ///< comes back without crossing
  rigid_body,  ///< goes on and is not deformed: nothing brings it back
  slack,       ///< goes on and is deformed: nothing resists
  growing,     ///< leaves the equilibrium
};

/// All of them, in the order above.
std::span<const ModeKind> mode_kinds();
inline std::span<const ModeKind> enum_values(ModeKind) {
  return mode_kinds();
}
/// "vibration", "overdamped", "rigid-body", "slack", "growing".
std::string_view word(ModeKind);

/// A free vibration of small size about an equilibrium: Re((shape + i quadrature) exp(λt)) with
/// λ = −decay + 2πi frequency.
struct VibrationMode {
  ModeKind kind = ModeKind::vibration;
  double frequency = 0;      ///< that it is seen to have, 1/s; 0 where it does not go to and fro
  double damping_ratio = 0;  ///< of the critical damping; below 0 where it grows to and fro
  double decay = 0;          ///< 1/s; below 0 where it grows
  /// |(λ² M + λ D + K) φ| over the sum of the sizes of its terms.
  double residual = 0;
  /// φ on the nodal coordinates, with φ* M φ = 1 kg m²/(kg m²): its positions in 1/√kg, its slopes in
  /// 1/(m √kg). Its greatest displacement is along an axis where other modes of its frequency let it.
  Eigen::VectorXd shape;
  /// Its imaginary part; empty of a mode that passes through its rest everywhere at once.
  Eigen::VectorXd quadrature;
};

/// What a method that looks for vibrations found; empty of others.
struct Vibrations {
  std::vector<VibrationMode> modes;  ///< growing ones first, then those without frequency, then rising
  int rigid_body = 0;                ///< how many of them are rigid-body motions
  double spin = 0;                   ///< of the frame in which the cable rests, rad/s
  Eigen::Vector3d axis{0, 0, 0};     ///< of the spin, a unit vector; 0 without
  /// Greatest |φᵢᵀ M φⱼ − δᵢⱼ|; -1 of damped modes and of those in a spinning frame, which have none.
  double orthonormality = -1;
};

/// Greatest displacement of a node in a mode, whatever its phase, 1/√kg.
double greatest_displacement(const VibrationMode& mode);

}  // namespace plumb
