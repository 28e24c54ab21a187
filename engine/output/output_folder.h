#pragma once

#include <string>

namespace plumb {

/// A folder of results in the making. Files are written into a temporary folder beside it, which takes its
/// place as a whole: whoever looks sees the old folder or the new one, and an interrupted run leaves the old
/// one or none.
class OutputFolder {
 public:
  /// Throws OutputError if `path` exists and is neither empty nor an output folder (one with a run.h5): it is
  /// not ours to replace; or if the temporary folder cannot be made.
  explicit OutputFolder(std::string path);

  /// Removes the temporary folder unless it was committed.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Copies the files of another output folder into this one.
  void start_from(const std::string& folder);

  /// Where to write for now.
  const std::string& working_path() const { return working_; }
  /// Where it will be.
  const std::string& path() const { return path_; }

  /// Path of a file in the folder for now; makes the folders on the way to it.
  std::string file(const std::string& name) const;

  /// Puts the new folder in the place of the old one. Throws OutputError.
  void commit();

 private:
  std::string path_;
  std::string working_;
  bool committed_ = false;
};

}  // namespace plumb
