#pragma once

#include <string>
#include <vector>

#include "engine/integrate/method_info.h"
#include "engine/read/toml_value.h"

namespace plumb {

/// The keys of [method] that a method takes besides its name.
std::vector<std::string> method_keys(const MethodInfo& method);

/// The method that a case names, or nullptr where there is none by that name.
const MethodInfo* named_method(const TomlValue& root);

/// Where an override has given the case another method than its file has, or a step where the file has
/// tolerances or the other way round (`file` is what the file alone says), takes the keys of the file's
/// [method] that no longer apply out of `merged`. Returns a remark each.
std::vector<std::string> drop_overruled_keys(const TomlValue& file, TomlValue& merged);

}  // namespace plumb
