#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case.h"

namespace plumb {

/// A method as journals and study files keep it. Reading throws nlohmann's exceptions.
nlohmann::json method_to_json(const MethodSpec& method);
MethodSpec method_from_json(const nlohmann::json& json);

}  // namespace plumb
