#pragma once

#include <string>

#include "engine/run/output_folder.h"
#include "engine/study/runner.h"
#include "report/program/kept_points.h"
#include "report/program/options.h"

namespace plumb {

/// Whether a command computes a part of a study only: --share or --only.
bool computes_a_part(const Options& options);

/// What the default output folder of a part has after that of the whole: ".share-3-of-16", ".missing".
std::string part_suffix(const Options& options);

/// What a command computes. The list of --only is read, with the points that it holds for others. Throws
/// UsageError and InputError.
Scope scope_asked_for(const Options& options, KeptPoints& points);

/// Takes in the journals that --merge names: folders of shares, finished or not, or the files themselves.
/// Throws InputError that names the one which is none, or of another case or program.
void merge_journals(const Options& options, const StudyIdentity& identity, Journal& journal,
                    Console& console);

/// The files that --merge and --only read.
std::vector<std::string> journals_read(const Options& options);

/// Puts the points of a part into its folder, and says how they are put together with others.
ExitStatus keep_part(const Runner& runner, const KeptPoints& points, const std::string& kind,
                     OutputFolder& folder, const Options& options, Console& console);

/// Says which points are missing and writes the list of them beside the output folder.
ExitStatus say_missing(const Runner& runner, const StudyIdentity& identity, const std::string& folder,
                       const std::string& kind, const Options& options, Console& console);

}  // namespace plumb
