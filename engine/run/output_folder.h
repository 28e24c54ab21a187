#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/folder_survey.h"
#include "engine/base/manifest.h"
#include "engine/base/part_folder.h"

namespace plumb {

/// What an output folder is used for.
struct FolderUse {
  FolderContent content = FolderContent::results;
  /// Files of a report beside index.html and results.json, which it may write too.
  std::span<const std::string_view> formats = {};
  /// Files that are read and must stay what they are.
  std::vector<std::string> reads = {};
  /// Files that the content is made from. Where they lie in the folder they may be written again if they are
  /// ours, and are left as they are if they are not.
  std::vector<std::string> sources = {};
  /// Files of the folder that are ours stay unless they are written again.
  bool adds = false;
  /// The folder may hold files of others even without a manifest.
  bool beside_others = false;
  /// Is told what was found and done that the user may not have expected, a sentence each.
  std::function<void(const std::string&)> remark = {};
};

/// Clears what killed programs left behind on the way to the file or folder at `path`, and says so.
void clear_leftovers_of(const std::string& path, const std::function<void(const std::string&)>& remark);

/// A folder of results in the making. Files are written into a temporary folder, and are put in place
/// together by commit(): whoever looks sees the old folder or the new one, and an interrupted program leaves
/// the old one or none. Where the folder holds files of others, or is the one that the program stands in,
/// files are put in place one after another instead, and each is the old or the new one; the manifest lists
/// both until that is done.
///
/// Nothing that is not ours is ever replaced or removed: of what is there only files that manifest.json lists
/// and that still are what it says. Files may be written from several threads.
class OutputFolder {
 public:
  /// Links to the folder are followed, none in it. Throws OutputError, before anything is done: if `path` is
  /// a file; if it is not empty and has no manifest.json of ours; or if a file that is not ours, or was
  /// changed since, has a name that `use` may write; or if the temporary folder cannot be made. Throws
  /// UsageError if a file that is read would be replaced.
  explicit OutputFolder(const std::string& path, FolderUse use = {});

  /// Removes the temporary folder.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Throws as the constructor does, and makes nothing.
  static void check(const std::string& path, const FolderUse& use);

  /// Writes a file of the folder: "frames/0000.png". Throws WriteError that names where it will be.
  void write(const std::string& name, std::string_view bytes);

  /// Whether a file was written and is still to be put in place.
  bool holds(const std::string& name) const;

  /// A file that was written. Throws WriteError if it cannot be read.
  std::string read(const std::string& name) const;

  /// Takes a file of the folder over into the new one, if there is one and it is ours.
  void keep(const std::string& name);

  /// Where it will be, with all links followed.
  const std::string& path() const { return path_; }

  /// Puts the new files in the place of the old ones. Throws OutputError; all is as it was then.
  void commit();

 private:
  OutputFolder(const std::string& path, FolderUse use, bool only_checks);

  void put(const std::string& name, std::string_view bytes);
  void place();
  FolderSurvey look() const;
  bool is_source(const std::string& name) const;
  void refuse_conflicts(const FolderSurvey& survey) const;
  void refuse_taken_names(const FolderSurvey& survey);
  void refuse_other_manifest(const FolderSurvey& survey) const;
  [[noreturn]] void refuse(const std::string& name, bool changed) const;
  [[noreturn]] void fail(const std::string& name, int error) const;
  std::string set_aside();

  std::string path_;
  FolderUse use_;
  std::unique_ptr<PartFolder> part_;
  Descriptor made_;           ///< the folder in it that is to be the new one
  ListedFiles ours_;          ///< when it was made
  FoundManifest began_with_;  ///< the manifest that was there then
  ListedFiles written_;
  mutable std::mutex writing_;
};

}  // namespace plumb
