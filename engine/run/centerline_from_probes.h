#pragma once

#include <optional>
#include <string>

#include "engine/case/given_run.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// A motion to be looked at, made from what an external run tells of some places of the cable.
struct DrawnCurve {
  /// Many equal elements along the places, without energies; nothing where there is not enough to draw.
  std::optional<Trajectory> motion;
  std::string in_words;  ///< what it is drawn through, or why it is not drawn
};

/// A curve through all places where the external run has a position with its three components, and through
/// the first end where it is held at the origin; two or more are needed. With a slope at each of them it is
/// the cubic Hermite curve, as of finite elements with these nodes; else a natural cubic spline over the
/// material coordinate. Over time it is taken `frame_rate` (1/s) times a second up to the end of the case.
DrawnCurve curve_through_probes(const Case& spec, const GivenRun& given, const std::string& name,
                                double frame_rate);

}  // namespace plumb
