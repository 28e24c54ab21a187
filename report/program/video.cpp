#include "report/program/video.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <vector>

#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/base/file_writing.h"
#include "engine/base/interrupt.h"
#include "report/program/found_program.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* encoder = "ffmpeg";
constexpr int not_there = 127;
constexpr const char* log_name = "ffmpeg.log";

std::vector<std::string> arguments(const std::string& file, double frame_rate) {
  std::vector<std::string> all{encoder, "-loglevel", "error", "-y", "-f", "image2pipe", "-framerate",
                               fmt::format("{:.6g}", frame_rate), "-c:v", "png", "-i", "-",
                               // Most players know no other colours, which need even sides.
                               "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"};
  // A name that begins with - is a file as well.
  all.push_back(file.starts_with('-') ? "./" + file : file);
  return all;
}

}  // namespace

Video::Video(const std::string& file, double frame_rate) : file_(file), place_(place_of_file(file)) {
  if (!file.ends_with(".mp4") && !file.ends_with(".webm"))
    throw UsageError(fmt::format("--video {}: must end in .mp4 or .webm", file));
  if (found_program(encoder).empty())
    throw OutputError(
        fmt::format("{}: needs ffmpeg, which is not installed; animation.png needs nothing", file));
  if (!place_.empty()) {
    const fs::path place = fs::absolute(place_);
    const std::string name = place.filename().string();
    try {
      clear_leftovers(place.parent_path().string(), name);
      part_ = std::make_unique<PartFolder>(place.parent_path().string(), name);
      for (const std::string& made : {name, std::string(log_name)}) part_->own(made);
    } catch (const std::system_error& error) {
      throw WriteError(file, error.code().value());
    }
  }
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw WriteError(file, errno);
  // It works in the temporary folder, so that it speaks of no other name than that of the file.
  std::vector<std::string> words = arguments(part_ ? fs::path(place_).filename().string() : file, frame_rate);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  child_ = ::fork();
  if (child_ == 0) {
    // Not to finish what nobody waits for any more.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
    // What is there already would be closed on the way to the program.
    if (ends[0] == STDIN_FILENO) ::fcntl(STDIN_FILENO, F_SETFD, 0);
    ::dup2(ends[0], STDIN_FILENO);
    if (part_ && ::fchdir(part_->descriptor()) != 0) ::_exit(not_there);
    // Standard output may be where frames go, and an error of ours is one line.
    const int log = ::open(part_ ? log_name : "/dev/null", O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    ::execvp(pointers[0], pointers.data());
    ::_exit(not_there);
  }
  ::close(ends[0]);
  pipe_ = ends[1];
  if (child_ < 0) {
    const int error = errno;
    close_pipe();
    throw WriteError(file, error);
  }
}

Video::~Video() {
  if (child_ < 0) return;
  close_pipe();
  ::waitpid(child_, nullptr, 0);
}

std::string Video::complaint() const {
  if (!part_) return "";
  const FileText log = read_file_text(part_->path() + "/" + log_name);
  const std::size_t end = log.text.find_last_not_of(" \r\n");
  if (end == std::string::npos) return "";
  const std::size_t begin = log.text.find_last_of("\r\n", end);
  return ": " + log.text.substr(begin == std::string::npos ? 0 : begin + 1, end - (begin + 1) + 1);
}

void Video::close_pipe() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
}

void Video::add(const std::string& png) {
  for (std::size_t done = 0; done < png.size();) {
    const ssize_t written = ::write(pipe_, png.data() + done, png.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw WriteError(file_, fmt::format("ffmpeg ended early{}", complaint()));
    done += static_cast<std::size_t>(written);
  }
}

void Video::finish() {
  close_pipe();
  int status = 0;
  const int child = child_;
  child_ = -1;
  if (::waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw WriteError(file_, fmt::format("ffmpeg failed{}", complaint()));
  if (!part_) return;
  const std::string name = fs::path(place_).filename().string();
  const Descriptor made(::openat(part_->descriptor(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  if (!made) throw WriteError(file_, "ffmpeg made no file");
  int error = flush_to_disk(made.get());
  if (error == 0 && ::renameat(part_->descriptor(), name.c_str(), AT_FDCWD, place_.c_str()) != 0)
    error = errno;
  if (error != 0) throw WriteError(file_, error);
}

}  // namespace plumb
