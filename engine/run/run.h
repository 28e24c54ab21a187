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
};

}  // namespace plumb
