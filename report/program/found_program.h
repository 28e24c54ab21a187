#pragma once

#include <string>

namespace plumb {

/// Where a program is that PATH finds; empty: it is not installed.
std::string found_program(const std::string& name);

}  // namespace plumb
