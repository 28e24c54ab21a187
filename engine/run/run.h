#pragma once

#include "engine/case/case_source.h"
#include "engine/integrate/trajectory.h"
#include "engine/run/probes.h"
#include "engine/run/provenance.h"

namespace plumb {

/// A finished run: all that pictures and reports are made from.
struct Run {
  LoadedCase loaded;
  Trajectory trajectory;
  ProbeTable probes;
  Provenance provenance;
  ProbeTable modes = {};  ///< mode_table of the trajectory
};

/// Whether a run is one of modes, which stand in the place of times.
bool has_modes(const Run& run);

/// The first external run of a case without [method] as the run that is reported: ended as its file says, or
/// completed where that says nothing, with neither states nor energies nor counters.
Run reported_run(LoadedCase loaded, Provenance provenance);

}  // namespace plumb
