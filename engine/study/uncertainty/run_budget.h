#pragma once

#include "engine/case/case_source.h"
#include "engine/study/runner.h"
#include "engine/study/uncertainty/error_budget.h"

namespace plumb {

/// Computes the error budget that a case asks for, in parallel over the processors. A run that fails is a
/// result. Throws Interrupted if the user stops it.
ErrorBudget run_budget(const LoadedCase& loaded, Runner& runner);

}  // namespace plumb
