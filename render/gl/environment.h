#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// A variable of the environment that the program looks at.
struct EnvironmentVariable {
  std::string_view name;
  std::string_view meaning;  ///< one phrase, with what it may be
};

/// Every one of them.
std::span<const EnvironmentVariable> environment_variables();

/// Throws UsageError where one of them has a value that is not allowed: it names the variable, the value and
/// what is.
void check_environment();

/// One line for each variable that is set and whose name is nearly that of one of them.
std::vector<std::string> mistyped_variables();

}  // namespace plumb
