#pragma once

#include "engine/input/case_source.h"
#include "engine/integrate/trajectory.h"
#include "engine/output/probes.h"
#include "engine/output/provenance.h"

namespace plumb {

/// A finished run: all that pictures and reports are made from.
struct Run {
  LoadedCase loaded;
  Trajectory trajectory;
  ProbeTable probes;
  Provenance provenance;
};

}  // namespace plumb
