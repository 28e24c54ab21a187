#pragma once

#include <string>
#include <string_view>

#include "engine/read/toml_value.h"

namespace plumb {

/// Replaces or adds the value that an override names: "cable.elements=8", "probe.0.at=0.5",
/// "loads.gravity.1=-9.8". What stands behind the '=' is a TOML value, or a bare string where it is not one.
/// Throws UsageError where the override is malformed, and InputError where its key leads nowhere.
void apply_override(TomlValue& root, const std::string& text);

/// Refuses the value that a case has under a key, "figure.0.name", for what a reader of the case does not
/// know. Throws InputError at its place.
[[noreturn]] void refuse_key(const CaseSource& source, const std::string& key, std::string_view what);

}  // namespace plumb
