#pragma once

#include <string>
#include <vector>

#include "engine/input/toml_value.h"
#include "engine/integrate/method_info.h"

namespace plumb {

/// The keys of [method] that a method takes besides its name.
std::vector<std::string> method_keys(const MethodInfo& method);

/// Where an override has given the case another method than its file has (`file` is what the file alone
/// says), takes the file's keys that belong to the file's method, and not to the new one, out of `merged`.
/// Returns a remark each.
std::vector<std::string> drop_keys_of_replaced_method(const TomlValue& file, TomlValue& merged);

/// Where the method takes either a step or tolerances and an override gives the one, takes the file's other
/// out of `merged`. Returns a remark each.
std::vector<std::string> drop_replaced_step_control(TomlValue& merged);

}  // namespace plumb
