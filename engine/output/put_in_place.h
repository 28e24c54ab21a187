#pragma once

#include <string>

#include "engine/output/folder_survey.h"
#include "engine/output/manifest.h"
#include "engine/output/part_folder.h"

namespace plumb {

/// Files that are whole in a temporary folder, and the folder where they are to be.
struct PlacedFiles {
  PartFolder& part;
  std::string path;      ///< of the folder
  ListedFiles written;   ///< what `part` holds
  ListedFiles ours{};    ///< what is ours in the folder now
  ListedFiles kept{};    ///< what of that stays
  ListedFiles listed{};  ///< what the folder's manifest lists, there or not
};

/// Writes manifest.json into an open folder. Throws std::system_error.
void write_manifest(int folder, const Manifest& manifest);

/// Makes the temporary folder, which lies beside the other one, that folder in one step. `old` is the open
/// folder that is there, or closed; all in it must be ours. False where the file system has no such step, and
/// nothing is done. Throws WriteError; all is as it was then.
bool put_at_once(const PlacedFiles& files, const Descriptor& old, FolderContent content);

/// Puts the files into the folder one after another, and removes those that are ours and neither written nor
/// kept. Throws WriteError; all is as it was then.
void put_one_by_one(const PlacedFiles& files);

/// Whether a file of this name below a temporary folder is one that the program may have left there.
bool is_made_on_the_way(FolderContent content, std::string_view name);

}  // namespace plumb
