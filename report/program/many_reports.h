#pragma once

#include <string>
#include <vector>

#include "report/index/run_index.h"
#include "report/program/console.h"
#include "report/program/installed_cases.h"
#include "report/program/options.h"

namespace plumb {

/// Runs several cases, each in a process and into a folder of its own below that of -o (default: output/ and
/// the name of the folder of cases, else output), and writes the index over them there. All cases are checked
/// before any is run: where there are faults, each is said, and the worst is how it ends. Else that is the
/// greatest exit status of the cases. Throws UsageError for options that are for one case.
ExitStatus run_many(const CaseList& cases, const Options& options, Console& console);

/// Writes the index over reports that are there into the folder of -o (default: output).
ExitStatus index_many(const std::vector<std::string>& folders, const Options& options, Console& console);

/// Where an index goes without -o.
inline constexpr const char* default_index_folder = "output";

/// What an index may touch: all that is not of an index stays.
FolderUse use_of_index(Console& console);

/// Whether an index may have a file or folder of this name.
bool is_of_index(const std::string& name);

/// A report that lies in a folder, with a thumbnail of what it shows; `seen` is the folder seen from the
/// index, `among` how many reports there are: the more, the smaller it is. Throws InputError for a document
/// that has not what a report has.
IndexedReport report_in(const std::string& folder, const std::string& seen, const Document& document,
                        std::size_t among);

/// Draws the figures of an index and writes all of it; says and prints what it is asked to. `at_once` is how
/// many ran side by side; 0: none was run. Returns the greatest of their exit statuses.
ExitStatus write_index(std::vector<IndexedReport> reports, std::size_t at_once, OutputFolder& folder,
                       const Options& options, Console& console, const Beside& beside = {});

}  // namespace plumb
