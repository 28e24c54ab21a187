#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/beneath.h"
#include "engine/base/manifest.h"

namespace plumb {

/// What a command may write into an output folder.
enum class FolderContent {
  run,       ///< run.h5 and probes.csv
  pages,     ///< index.html, the formats of a report, and figures
  pictures,  ///< those of a run, and figures, frames and animations
  results,   ///< all that a run, a report or a study makes
  copies,    ///< files of any name
};

/// Whether a file of this name below an output folder may be written. `formats` are the names of files that a
/// report has beside index.html and results.json.
bool belongs_to(FolderContent content, std::string_view name, std::span<const std::string_view> formats = {});

/// What is in a folder.
struct FolderSurvey {
  Descriptor folder;  ///< closed where there is none
  FoundManifest manifest = {};
  ListedFiles ours = {};  ///< what of it may be replaced and removed
  /// Names that are not ours: at the top, in figures and frames, and in folders that hold ours. A folder that
  /// holds nothing of ours is named itself.
  std::set<std::string> others = {};
};

/// Looks into the folder at `path`; `formats` as above. Throws std::system_error.
FolderSurvey look_into(const std::string& path, FolderContent content,
                       std::span<const std::string_view> formats = {});

}  // namespace plumb
