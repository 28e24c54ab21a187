#pragma once

#include <string>

#include "engine/base/file_writing.h"
#include "engine/base/folder_survey.h"
#include "engine/base/manifest.h"
#include "engine/base/part_folder.h"

namespace plumb {

/// A name of the folder is taken by what is not ours, or what was ours is changed.
class NameTaken : public WriteError {
 public:
  using WriteError::WriteError;
};

/// What of a temporary folder is to become the folder of results.
inline constexpr const char* folder_made = "new";

/// Files that are whole in a temporary folder, and the folder where they are to be.
struct PlacedFiles {
  PartFolder& part;
  int made;              ///< the open folder `folder_made` of `part`
  std::string path;      ///< of the folder
  ListedFiles written;   ///< what `made` holds
  std::string manifest;  ///< that of the folder now; empty where it has none
  ListedFiles ours;      ///< what is ours in the folder now
  ListedFiles kept{};    ///< what of that stays
  ListedFiles listed{};  ///< what the folder's manifest lists, there or not
};

/// Writes manifest.json beside the files that are made. Throws std::system_error.
void write_manifest(PartFolder& part, const ListedFiles& written);

/// Makes what was made, which lies beside the other folder, that folder in one step. `old` is the open folder
/// that is there, or closed. What is in it and is not ours is put into the new one as well where that name is
/// free, else it stays in the temporary folder. False where the file system has no such step, and nothing is
/// done. Throws WriteError; all is as it was then.
bool put_at_once(const PlacedFiles& files, const Descriptor& old);

/// Puts the files into the folder one after another, and removes those that are ours and neither written nor
/// kept. Throws WriteError; all is as it was then.
void put_one_by_one(const PlacedFiles& files);

}  // namespace plumb
