#pragma once

#include <string>

#include "engine/read/toml_value.h"

namespace plumb {

/// A value as one line of TOML, as an override takes it behind its '='.
std::string value_text(const TomlValue& value);

}  // namespace plumb
