#pragma once

#include <string>

namespace plumb {

/// A video in the making: PNG frames go to an ffmpeg of the machine.
class Video {
 public:
  /// `file` ends in .mp4 or .webm, else UsageError; `frame_rate` in 1/s. Throws OutputError that says so
  /// where there is no ffmpeg.
  Video(const std::string& file, double frame_rate);
  /// Removes the file unless it was finished.
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// Throws OutputError where ffmpeg takes no more.
  void add(const std::string& png);
  /// Waits until the file is whole. Throws OutputError where ffmpeg failed.
  void finish();

 private:
  void close_pipe();

  std::string file_;
  int pipe_ = -1;
  int child_ = -1;
};

}  // namespace plumb
