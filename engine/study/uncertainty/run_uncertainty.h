#pragma once

#include "engine/run/run.h"
#include "engine/study/runner.h"
#include "engine/study/uncertainty/uncertainty.h"

namespace plumb {

/// Estimates what [uncertainty] of a run's case asks for, in parallel over the processors. A run that fails
/// leaves its part not estimated, a sample that fails is counted. Throws Interrupted if the user stops it.
Uncertainty run_uncertainty(const Run& run, Runner& runner);

}  // namespace plumb
