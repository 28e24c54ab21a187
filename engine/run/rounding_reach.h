#pragma once

#include "engine/case/case.h"
#include "engine/case/probe_table.h"

namespace plumb {

/// How far each column of a run's probes may be from itself at each output where the same computation is
/// rounded otherwise, as by another compiler or processor: so many times the greatest distance up to there to
/// a run of a cable that is longer by a rounding, which is made here and takes as long as the run did.
/// Infinite where that run has ended. Of a motion that is not predictable it grows until it says nothing.
ProbeTable rounding_reach(const Case& spec, const ProbeTable& probes);

/// Times that distance: each of the steps of a computation is rounded, where the neighbour differs once.
inline constexpr double roundings = 100;

}  // namespace plumb
