#pragma once

#include <functional>

#include "engine/run/run.h"
#include "engine/study/uncertainty/uncertainty.h"

namespace plumb {

/// Called when a run has ended, with the share of all that have, 0 to 1. Never called twice at once, but from
/// any thread.
using UncertaintyProgress = std::function<void(double share)>;

/// Estimates what [uncertainty] of a run's case asks for, in parallel over the processors. A run that fails
/// leaves its part not estimated, a sample that fails is counted. Throws Interrupted if the user stops it.
Uncertainty run_uncertainty(const Run& run, const UncertaintyProgress& progress = {});

}  // namespace plumb
