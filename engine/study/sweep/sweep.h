#pragma once

#include <string>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/integrate/trajectory.h"
#include "engine/run/provenance.h"

namespace plumb {

/// One random case and how it ended.
struct SweepRun {
  long number = 0;                     ///< case k of the seed
  std::vector<std::string> overrides;  ///< what makes it of the file's case, as --set takes them
  std::string method;
  Outcome outcome = Outcome::not_run;  ///< `completed` only where no reference could be had
  std::string message;
  double error = -1;         ///< greatest distance of a node to the reference that judged it, m; -1: none
  double second_error = -1;  ///< the same to a reference by an unlike method, m; -1: none
  double disagreement = -1;  ///< greatest distance of a node between these references, m; -1: none
  double judged_until = -1;  ///< s, up to which the references agree; -1: not judged
  double seconds = -1;       ///< that the time loop took
  bool finite = true;        ///< no number of the trajectory is infinite or not a number
  std::string fault;         ///< "crashed (signal 11)", "hung", "threw: …"; empty: none

  /// Ended in an outcome that a judged run can have: neither `not_run` nor `completed`.
  bool judged() const;
  /// Accurate, although it is further from the second reference than the tolerance and what the references
  /// differ by, or has no such distance.
  bool wrongly_accurate(double tolerance) const;
};

/// Random cases over methods, steps, parameters, meshes, supports and their motion, strain models, loads,
/// masses and damping.
struct Sweep {
  LoadedCase loaded;
  SweepSpec spec;
  std::vector<SweepRun> runs;  ///< in the order of their numbers
  Provenance provenance;
};

}  // namespace plumb
