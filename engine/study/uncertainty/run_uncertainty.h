#pragma once

#include "engine/run/run.h"
#include "engine/study/runner.h"
#include "engine/study/uncertainty/error_budget.h"
#include "engine/study/uncertainty/uncertainty.h"

namespace plumb {

/// Estimates what [uncertainty] of a run's case asks for, in parallel over the processors. What a reference
/// shares with the run is no part of it. An error budget, where there is one, says what errors the figures of
/// its reference have themselves, and what accounts for what is found. A run that fails leaves its part not
/// estimated, a sample that fails is counted. Throws Interrupted if the user stops it.
Uncertainty run_uncertainty(const Run& run, Runner& runner, const ErrorBudget* budget = nullptr);

}  // namespace plumb
