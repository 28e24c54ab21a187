#include "report/program/video.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <vector>

#include "engine/errors.h"
#include "engine/interrupt.h"

namespace plumb {
namespace {

constexpr const char* program = "ffmpeg";
constexpr int not_there = 127;

std::vector<std::string> arguments(const std::string& file, double frame_rate) {
  std::vector<std::string> all{program, "-loglevel", "error", "-y", "-f", "image2pipe", "-framerate",
                               fmt::format("{:.6g}", frame_rate), "-c:v", "png", "-i", "-",
                               // Most players know no other colours, which need even sides.
                               "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"};
  // A name that begins with - is a file as well.
  all.push_back(file.starts_with('-') ? "./" + file : file);
  return all;
}

bool is_there() {
  const char* path = std::getenv("PATH");
  std::string folders = path != nullptr ? path : "";
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    if (::access((folders.substr(begin, end - begin) + "/" + program).c_str(), X_OK) == 0) return true;
    begin = end + 1;
  }
  return false;
}

}  // namespace

Video::Video(const std::string& file, double frame_rate) : file_(file) {
  if (!file.ends_with(".mp4") && !file.ends_with(".webm"))
    throw UsageError(fmt::format("--video {}: must end in .mp4 or .webm", file));
  if (!is_there())
    throw OutputError(
        fmt::format("{}: needs ffmpeg, which is not installed; animation.png needs nothing", file));
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw OutputError(fmt::format("{}: {}", file, std::strerror(errno)));
  std::vector<std::string> words = arguments(file, frame_rate);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  child_ = ::fork();
  if (child_ == 0) {
    // Not to finish what nobody waits for any more.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
    ::dup2(ends[0], STDIN_FILENO);
    // Standard output may be where frames go.
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    ::execvp(pointers[0], pointers.data());
    ::_exit(not_there);
  }
  ::close(ends[0]);
  pipe_ = ends[1];
  begin_unfinished(file_);
  if (child_ < 0) {
    close_pipe();
    throw OutputError(fmt::format("{}: {}", file, std::strerror(errno)));
  }
}

Video::~Video() {
  end_unfinished(file_);
  if (child_ < 0) return;
  close_pipe();
  ::waitpid(child_, nullptr, 0);
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

void Video::close_pipe() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
}

void Video::add(const std::string& png) {
  for (std::size_t done = 0; done < png.size();) {
    const ssize_t written = ::write(pipe_, png.data() + done, png.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0)
      throw OutputError(fmt::format("{}: ffmpeg ended early: {}", file_, std::strerror(errno)));
    done += static_cast<std::size_t>(written);
  }
}

void Video::finish() {
  close_pipe();
  int status = 0;
  const int child = child_;
  child_ = -1;
  if (::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
  throw OutputError(fmt::format("{}: ffmpeg failed", file_));
}

}  // namespace plumb
