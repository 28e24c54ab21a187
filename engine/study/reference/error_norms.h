#pragma once

#include <array>
#include <string_view>

#include "engine/integrate/trajectory.h"

namespace plumb {

/// How far one run is from a reference, in several norms taken from the same outputs. -1: not taken.
struct ErrorNorms {
  double tip_max = -1;  ///< greatest distance of the last end over the outputs, m
  double tip_rms = -1;  ///< root mean square of that distance, m
  double curve = -1;   ///< distance of the whole curve, m: root of its square's mean over arc length and time
  double energy = -1;  ///< the run's own relative energy drift
};

enum class ErrorNorm { tip_max, tip_rms, curve, energy };
inline constexpr std::array error_norm_list{ErrorNorm::tip_max, ErrorNorm::tip_rms, ErrorNorm::curve,
                                            ErrorNorm::energy};

/// "tip-max", "tip-rms", "curve", "energy".
std::string_view word(ErrorNorm);
/// "m", or "1" for the energy.
std::string_view unit(ErrorNorm);
double value(const ErrorNorms& norms, ErrorNorm norm);

/// The distance of a run to a reference over the same outputs; they may have different meshes of one cable.
/// Points of equal arc length are compared, and the arc length is integrated by Gauss's rule between any two
/// nodes of either mesh, which is exact. All distances are -1 where the run did not reach every output
/// of the reference.
ErrorNorms error_norms(const Trajectory& run, const Trajectory& reference);

}  // namespace plumb
