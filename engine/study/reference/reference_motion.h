#pragma once

#include "engine/case/case.h"
#include "engine/study/reference/certified_reference.h"
#include "engine/study/reference/trajectory_divergence.h"

namespace plumb {

/// The exact motion that the runs on one mesh, at one value of the parameter, are judged by.
struct StabilityReference {
  double parameter = 0;
  int elements = 0;
  double duration = 0;            ///< s
  std::string first, second;      ///< the methods that were held together
  double agreement = -1;          ///< greatest distance of their tips, m; -1: they could not be compared
  double trusted_until = -1;      ///< s: up to there they agree to a tenth of the tolerance
  double frequency_at_start = 0;  ///< of the fastest vibration, rad/s
  double frequency_at_worst = 0;  ///< the greatest along the motion, rad/s
};

/// One mesh at one value of the parameter with the motion that its runs are judged by.
struct ReferenceMotion {
  double parameter = 0;  ///< 0 where none is varied
  Case spec;             ///< with the time to be run
  Trajectory trajectory;
  MethodSpec method;  ///< that gave the trajectory; without a name where none did
  StabilityReference summary;
  TrajectoryDivergence divergence;

  /// The time up to which a run may be held against the motion, s: neighbours stay together and the reference
  /// is known.
  double horizon() const;
  /// "4 elements, parameter 1", as a key.
  std::string in_words() const;
};

/// Integrates the motion of a case by two unlike methods until they agree to far less than `tolerance` (m),
/// and finds how fast its neighbours part and how fast it vibrates. `time_limit` (s) is that of the
/// reference.
ReferenceMotion reference_motion(const Case& spec, double parameter, double tolerance, double time_limit);

}  // namespace plumb
