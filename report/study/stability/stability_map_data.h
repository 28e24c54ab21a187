#pragma once

#include <string>

#include "engine/study/stability/stability.h"

namespace plumb {

/// What the maps of a page show, as JSON on one line: for each map its settings, values and limits, and for
/// each point `o` (place of its outcome among `outcomes`), `e` (error, m), `j` (judged until, s), `t` (time
/// reached, s), `d` (energy change) and `m` (message). What is not known or not finite is null.
std::string stability_map_data(const Stability& study);

}  // namespace plumb
