#pragma once

#include <string>

namespace plumb {

/// A folder of results in the making. Files are written into a temporary folder beside it, which takes its
/// place as a whole: whoever looks sees the old folder or the new one, and an interrupted run leaves the old
/// one or none.
class OutputFolder {
 public:
  /// Throws OutputError if `path` exists and is neither empty nor an output folder (one with a run.h5, a
  /// study.h5 or a study.json): it is not ours to replace; if it is a mount point; or if the temporary folder
  /// cannot be made. Links are followed.
  explicit OutputFolder(std::string path);

  /// Removes the temporary folder unless it was committed.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Takes a file of the folder that will be replaced over into the new one, if there is one.
  void keep(const std::string& name);

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
