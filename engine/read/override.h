#pragma once

#include <string>

#include "engine/read/toml_value.h"

namespace plumb {

/// Replaces or adds the value that an override names: "cable.elements=8", "probe.0.at=0.5",
/// "loads.gravity.1=-9.8". What stands behind the '=' is a TOML value, or a bare string where it is not one.
/// Throws UsageError where the override is malformed, and InputError where its key leads nowhere.
void apply_override(TomlValue& root, const std::string& text);

}  // namespace plumb
