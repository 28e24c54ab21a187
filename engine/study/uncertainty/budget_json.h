#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/study/uncertainty/error_budget.h"

namespace plumb {

/// The `error_budget` of results.json and of assessment.json, which is all of it. What is not finite is null.
nlohmann::ordered_json budget_json(const ErrorBudget& budget);

/// Reads it back. Throws nlohmann's exceptions or std::runtime_error for what budget_json() does not make.
ErrorBudget budget_from_json(const nlohmann::ordered_json& json);

}  // namespace plumb
