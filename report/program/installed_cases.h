#pragma once

#include <string>
#include <vector>

namespace plumb {

/// The path of the case that the command line names: `name` itself where there is such a file, folder or
/// pattern; else that of the case of that name which came with the program, "pendulum" or
/// "failure/slack_cable". Throws InputError with the nearest name where a bare name is neither.
std::string case_named(const std::string& name);

/// The names of the cases that came with the program, in alphabetical order; none where there are none.
std::vector<std::string> installed_cases();

}  // namespace plumb
