#pragma once

#include <string>
#include <vector>

#include "engine/input/case.h"

namespace plumb {

/// The columns of all probes, in order.
std::vector<std::string> all_columns(const std::vector<ProbeSpec>& probes);

/// The probe that a column is of, or nullptr.
const ProbeSpec* probe_of(const std::string& column, const std::vector<ProbeSpec>& probes);

}  // namespace plumb
