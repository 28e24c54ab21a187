#pragma once

#include "engine/case/case.h"
#include "engine/study/reference/certified_reference.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// One mesh at one value of the parameter with the motion that its runs are judged by.
struct ReferenceMotion {
  double parameter = 0;  ///< 0 where none is varied
  Case spec;             ///< with the time to be run
  Trajectory trajectory;
  StabilityReference summary;
  Separation separation;

  /// The time up to which a run may be held against the motion, s: neighbours stay together and the reference
  /// is known.
  double horizon() const;
};

/// Integrates the motion of a case by two unlike methods until they agree to far less than `tolerance` (m),
/// and finds how fast its neighbours part and how fast it vibrates. `time_limit` (s) is that of the
/// reference.
ReferenceMotion reference_motion(const Case& spec, double parameter, double tolerance, double time_limit);

}  // namespace plumb
