#pragma once

#include <vector>

#include "engine/case/given_run.h"
#include "engine/case/probe_table.h"

namespace plumb {

/// What an external run has of the probes' columns, at its own times.
ProbeTable probe(const GivenRun& given);

/// The same at other times (s) within its first and last, interpolated (TimeInterpolation). Throws
/// std::out_of_range for a time outside.
ProbeTable probe(const GivenRun& given, const std::vector<double>& times);

/// What an external run would have at some of its times, none of them the first or the last, if it had only
/// every second one: interpolated between those before and after.
ProbeTable probe_without(const GivenRun& given, const std::vector<std::size_t>& outputs);

/// True for two tables of one run: the times of one are among those of the other, and there all columns of
/// both have the same values, at least one of which varies; all but for the rounding of a unit.
bool same_run(const ProbeTable& a, const ProbeTable& b);

}  // namespace plumb
