#pragma once

#include <array>
#include <string_view>

namespace plumb {

/// How far one run is from a reference, in several norms taken from the same outputs. -1: not taken.
struct ErrorNorms {
  double tip_max = -1;  ///< greatest distance of the last end over the outputs, m
  double tip_rms = -1;  ///< root mean square of that distance, m
  double curve = -1;   ///< distance of the whole curve, m: root of its square's mean over arc length and time
  double energy = -1;  ///< the run's own relative energy drift
};

enum class ErrorNorm { tip_max, tip_rms, curve, energy };
inline constexpr std::array error_norms{ErrorNorm::tip_max, ErrorNorm::tip_rms, ErrorNorm::curve,
                                        ErrorNorm::energy};

/// "tip-max", "tip-rms", "curve", "energy".
std::string_view word(ErrorNorm);
/// "m", or "1" for the energy.
std::string_view unit(ErrorNorm);
double value(const ErrorNorms& norms, ErrorNorm norm);

}  // namespace plumb
