#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// What a name of a probe, reference or figure may be: it becomes part of columns, file names and links.
inline constexpr std::string_view name_rule = "letters, digits, - and _, at most 100, not starting with -";

bool follows_name_rule(std::string_view name);

}  // namespace plumb
