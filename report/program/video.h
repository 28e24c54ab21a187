#pragma once

#include <memory>
#include <string>

#include "engine/base/part_folder.h"

namespace plumb {

/// A video in the making: PNG frames go to an ffmpeg of the machine. A file that is there already is replaced
/// only by a video that is whole.
class Video {
 public:
  /// `file` ends in .mp4 or .webm, else UsageError; `frame_rate` in 1/s. Throws OutputError that says so
  /// where there is no ffmpeg, or the folder of the file cannot be written to.
  Video(const std::string& file, double frame_rate);
  /// Removes what was made unless it was finished.
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// Throws OutputError where ffmpeg takes no more.
  void add(const std::string& png);
  /// Waits until the video is whole and puts it in place. Throws OutputError where that fails.
  void finish();

 private:
  void close_pipe();
  /// What ffmpeg said last, as a part of a sentence.
  std::string complaint() const;

  std::string file_;
  std::string place_;  ///< with links followed; empty where the file is written to as it is
  std::unique_ptr<PartFolder> part_;
  int pipe_ = -1;
  int child_ = -1;
};

}  // namespace plumb
