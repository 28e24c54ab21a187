#pragma once

#include <string>
#include <string_view>

#include "engine/base/message.h"

namespace plumb {

/// Where a value stands that the user gave.
struct Place {
  std::string name;  ///< of the file, or of the override: "--set cable.elements=0"
  int line = 0;      ///< from 1; 0 for an override, which has no lines
  int column = 0;    ///< from 1, in characters

  bool in_override() const { return line == 0; }
};

/// "cases/a.toml:4:10" or "--set cable.elements=0".
std::string to_string(const Place& place);

/// Throws the InputError "PLACE: KEY = VALUE: WHAT", in one line whatever the parts hold. `value` is as
/// written; an empty one is left out, and so are key and value where the name of an override shows them
/// already. `computed` is what an expression came to, or empty.
[[noreturn]] void refuse(const Place& place, std::string_view key, std::string_view value,
                         std::string_view what, std::string_view computed = {});

}  // namespace plumb
