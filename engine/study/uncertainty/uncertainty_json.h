#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/study/uncertainty/uncertainty.h"

namespace plumb {

/// The `uncertainty` of results.json and of assessment.json, which is all of it. What is not finite is null.
nlohmann::ordered_json uncertainty_json(const Uncertainty& uncertainty);

/// Reads it back. Throws nlohmann's exceptions or std::runtime_error for what uncertainty_json() does not
/// make.
Uncertainty uncertainty_from_json(const nlohmann::ordered_json& json);

}  // namespace plumb
