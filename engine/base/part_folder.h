#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "engine/base/beneath.h"
#include "engine/base/manifest.h"

namespace plumb {

/// Files that are ours by their names below a folder, each as one of a list; one without a list is ours
/// whatever is in it.
using OwnFiles = std::map<std::string, std::vector<ListedFile>>;

/// A folder `.NAME.part-XXXXXX` for what is to become `NAME`. A mark in it says that it is ours and which
/// files in it are, and a lock that it is in use, so that what a killed program left behind can be told from
/// the work of a running one and from what is somebody else's.
class PartFolder {
 public:
  /// Made in the folder `parent`. Throws std::system_error.
  PartFolder(const std::string& parent, const std::string& name);
  /// As clear().
  ~PartFolder();
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  const std::string& path() const { return path_; }
  int descriptor() const { return folder_.get(); }

  /// Opens a new file for writing, with the folders that it lies in, which is ours whatever is in it. Closed
  /// where there is none (errno tells).
  Descriptor create(const std::string& name);
  /// A file that somebody else is about to make for us. Throws std::system_error.
  void own(const std::string& name);
  /// Files that are ours as they are listed, and only so, by their names below `prefix`: those that are whole
  /// and those that are to be moved here. Throws std::system_error.
  void own(const ListedFiles& files, const std::string& prefix);

  /// Removes what of it is ours. False if some of that is still there.
  bool empty();
  /// The same, and the folder. Where something is left, which is not ours, its owner should see it: returns
  /// the first such file where it is now, within `NAME.new` or one numbered after it if that can be; else
  /// empty.
  std::string clear();
  /// It stays as it is, until a later command clears it.
  void let_go();

 private:
  bool note(const std::string& records);

  std::string path_;
  Descriptor folder_, mark_;
  OwnFiles own_;
};

/// Moves a file or folder to `path`, or with a number after it where that is taken. Returns where it is now,
/// or nothing.
std::string move_aside(const std::string& from, const std::string& path);

/// What became of what killed programs left behind.
struct Leftovers {
  int cleared = 0;                     ///< folders
  std::vector<std::string> kept = {};  ///< a file of each in which there were some of others, where it is now
};

/// Clears what programs that were killed left behind in `parent` on the way to `name`, as clear() does. A
/// folder counts only if its mark says that it is ours and no running program has it.
Leftovers clear_leftovers(const std::string& parent, const std::string& name);

}  // namespace plumb
