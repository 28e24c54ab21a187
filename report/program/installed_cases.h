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

/// The folders of those cases, each of which stands for all cases in it: "shelf".
std::vector<std::string> installed_folders();

/// Paths that a command line stands for: patterns such as cases/*.toml that the shell left alone are what
/// they match. Throws UsageError for a pattern that matches nothing.
std::vector<std::string> matching_paths(const std::vector<std::string>& arguments);

/// Cases that are to be run by one command.
struct CaseList {
  std::vector<std::string> paths;
  /// Of the folder, where one folder is all that was asked for: "shelf". Empty: the cases were named.
  std::string folder = {};
};

/// What the arguments of `plumb run` stand for, in their order: files and patterns, names as in case_named(),
/// and folders with all cases (*.toml) that lie directly in them, in alphabetical order. A folder is found as
/// a case is: in the current folder, else among those that came with the program, else in ./cases. Throws
/// InputError for a folder without a case and as case_named(), UsageError as matching_paths().
CaseList cases_named(const std::vector<std::string>& arguments);

}  // namespace plumb
