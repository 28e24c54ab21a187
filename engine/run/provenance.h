#pragma once

#include <string>
#include <utility>
#include <vector>

namespace plumb {

/// Where a result comes from, as names and values in the order to be shown: program, revision, compiler,
/// flags, libraries, machine, time.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// The provenance of something made by this program on this machine now.
Provenance provenance_now();

}  // namespace plumb
