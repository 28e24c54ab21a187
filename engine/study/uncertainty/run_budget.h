#pragma once

#include <functional>

#include "engine/case/case_source.h"
#include "engine/study/uncertainty/error_budget.h"

namespace plumb {

/// Called when a run has ended, with the share of all that have, 0 to 1. Never called twice at once, but from
/// any thread.
using BudgetProgress = std::function<void(double share)>;

/// Computes the error budget that a case asks for, in parallel over the processors. A run that fails is a
/// result. Throws Interrupted if the user stops it.
ErrorBudget run_budget(const LoadedCase& loaded, const BudgetProgress& progress = {});

}  // namespace plumb
