#pragma once

#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/case/probe_table.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// Reads the probes of a case off a trajectory at its outputs.
ProbeTable probe(const Case& spec, const Trajectory& trajectory);

/// The same at other times (s) within the trajectory; between two outputs positions and slopes are
/// interpolated by cubic Hermite polynomials from both outputs' coordinates and rates. Throws
/// std::out_of_range for a time outside.
ProbeTable probe(const Case& spec, const Trajectory& trajectory, const std::vector<double>& times);

/// What the probes would see at some outputs, none of them the first or the last, if the run did not have
/// them: interpolated as above between the output before and the one after.
ProbeTable probe_without(const Case& spec, const Trajectory& trajectory,
                         const std::vector<std::size_t>& outputs);

/// Comma-separated values: the header "t [s],mid.x [m],…" and a row an output time, 17 significant digits.
std::string to_csv(const ProbeTable& table);

}  // namespace plumb
