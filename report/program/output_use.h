#pragma once

#include <string>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/run/output_folder.h"
#include "report/program/console.h"
#include "report/program/options.h"

/// What the verbs read and write, so that nothing that is read is overwritten.
namespace plumb {

/// The files that a case is read from, and the results.json of --baseline.
std::vector<std::string> files_read(const LoadedCase& loaded, const Options& options);

/// The files that a report or the pictures of a run are made from; `path` is that of the run or its folder.
std::vector<std::string> source_files(const std::string& path);

/// The file of a run, or of another of those of a folder: `name` in the folder if `path` is one.
std::string file_in(const std::string& path, const char* name);

/// The name of the folder for what a case makes: that of its file without the ending. Throws UsageError for
/// one that is no name of a folder of its own, as "..".
std::string folder_name_of(const std::string& case_path);

/// The folder for the results of a case. What is noteworthy about it is said.
FolderUse folder_for(const LoadedCase& loaded, const Options& options, Console& console);

/// The folder for what is made from a finished run or study.
FolderUse folder_from(const std::string& run_path, Console& console);

/// Throws UsageError where the file that `option` names is one of those that are read, under whatever name,
/// or lies in the folder that is about to be replaced (empty: none). WriteError where there is no folder for
/// it.
void refuse_to_overwrite(const std::string& option, const std::string& file,
                         const std::vector<std::string>& reads, const std::string& folder = "");

/// Makes sure that pictures can be drawn: opens what they are drawn with, and the fonts. Returns
/// GlInfo::fingerprint(). Throws OutputError.
std::string try_drawing();

}  // namespace plumb
