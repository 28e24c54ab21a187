#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case.h"

namespace plumb {

/// A method as journals and study files keep it: name, parameters, and step or tolerances where it has them.
/// Reading throws nlohmann's exceptions.
nlohmann::ordered_json to_stored(const MethodSpec& method);
void from_stored(const nlohmann::ordered_json& json, MethodSpec& method);

}  // namespace plumb
