#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case.h"

namespace plumb {

/// A method as results.json and choice.json have it: its name, its step or tolerances, and its parameters,
/// all beside one another.
nlohmann::ordered_json method_json(const MethodSpec& method);

/// As journals and study files keep it: the same, with the parameters in an object of their own.
nlohmann::ordered_json to_stored(const MethodSpec& method);

/// Reads either. Throws nlohmann's exceptions or std::runtime_error.
void from_stored(const nlohmann::ordered_json& json, MethodSpec& method);

}  // namespace plumb
