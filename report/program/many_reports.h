#pragma once

#include <string>
#include <vector>

#include "report/program/console.h"
#include "report/program/options.h"

namespace plumb {

/// The cases of a command line: patterns such as cases/*.toml that the shell left alone are what they match.
/// Throws UsageError for a pattern that matches nothing.
std::vector<std::string> matching_paths(const std::vector<std::string>& arguments);

/// Runs several cases, each into a folder of its own below that of -o (default: output), and writes the index
/// over them there. All cases are read before any is run. Throws UsageError where two would share a folder.
ExitStatus run_many(const std::vector<std::string>& cases, const Options& options, Console& console);

/// Writes the index over reports that are there into the folder of -o (default: output).
ExitStatus index_many(const std::vector<std::string>& folders, const Options& options, Console& console);

}  // namespace plumb
