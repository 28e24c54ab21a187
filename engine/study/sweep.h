#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/input/case.h"
#include "engine/integrate/trajectory.h"
#include "engine/output/provenance.h"

namespace plumb {

/// One random case and how it ended.
struct SweepRun {
  long number = 0;                     ///< case k of the seed
  std::vector<std::string> overrides;  ///< what makes it of the file's case, as --set takes them
  Outcome outcome = Outcome::not_run;  ///< never `completed`
  std::string message;
  double error = -1;         ///< greatest distance of a node to the reference that judged it, m
  double second_error = -1;  ///< the same to another reference, made by an unlike method, m; -1: none
  double judged_until = -1;  ///< s
  bool finite = true;        ///< no number of the trajectory is infinite or not a number
};

/// Random cases over methods, steps, parameters, meshes, supports and strain models.
struct Sweep {
  std::string title;
  long seed = 0;
  double tolerance = 0;  ///< m
  std::vector<SweepRun> runs;
  Provenance provenance;

  /// Runs that ended accurate although the second reference is further than the tolerance and what the
  /// references differ by.
  std::vector<std::size_t> wrongly_accurate;
};

}  // namespace plumb
