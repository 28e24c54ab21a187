#pragma once

#include <string>

#include "engine/run/run.h"
#include "render/plot/plot.h"

namespace plumb {

/// Shades, in a panel over time, what is missing of a run that failed, so that its curves do not look like
/// the whole. Nothing for one that completed.
void mark_ending(const Run& run, Panel& panel);

/// The title of a figure; of a run that failed it says so, as not every figure has an axis of time.
std::string title_of(const Run& run, const std::string& title);

}  // namespace plumb
