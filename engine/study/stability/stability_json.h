#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/study/stability/stability.h"

namespace plumb {

/// All of a stability study, with the names of its members as keys. A number that is not finite is the
/// string "inf", "-inf" or "nan".
nlohmann::ordered_json stability_to_json(const Stability& study);

/// The other way. Throws std::runtime_error where something is missing, of the wrong type, or does not fit
/// together.
Stability stability_from_json(const nlohmann::ordered_json& json);

}  // namespace plumb
