#include "engine/base/file_text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "engine/base/message.h"

namespace plumb {
namespace {

constexpr std::uint64_t mebibyte = 1024 * 1024;

class OpenFile {
 public:
  // Without O_NONBLOCK the call would wait for whoever writes to a named pipe.
  explicit OpenFile(const std::string& path)
      : file_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {}
  ~OpenFile() {
    if (file_ >= 0) ::close(file_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  operator int() const { return file_; }

 private:
  int file_;
};

FileText failed(std::string why) {
  return {"", std::move(why)};
}

FileText failed_call() {
  return failed(std::generic_category().message(errno));
}

/// What a file is that is no regular one.
std::string sort_of(mode_t mode) {
  if (S_ISDIR(mode)) return std::generic_category().message(EISDIR);
  if (S_ISFIFO(mode)) return "it is a named pipe; only regular files are read";
  if (S_ISSOCK(mode)) return "it is a socket; only regular files are read";
  return "it is a device; only regular files are read";
}

FileText read_open(int file, std::uint64_t size) {
  constexpr std::size_t part = mebibyte;
  const std::string changed = "it changed its length while it was read";
  std::string text;
  text.reserve(size);
  while (text.size() <= size) {
    stop_if_interrupted();
    const std::size_t before = text.size();
    // One byte more than there should be: a file that grows, or that says it is empty and is not, is told.
    text.resize(before + std::min<std::uint64_t>(part, size - before + 1));
    const ssize_t count = ::read(file, text.data() + before, text.size() - before);
    if (count < 0 && errno != EINTR) return failed_call();
    text.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count == 0) return text.size() == size ? FileText{std::move(text), ""} : failed(changed);
  }
  return failed(size == 0 ? "it has no length of its own, as a file of the system" : changed);
}

}  // namespace

std::uint64_t longest(InputKind kind) {
  switch (kind) {
    case InputKind::case_file:
      return 4 * mebibyte;
    case InputKind::reference:
      return 16 * mebibyte;
    case InputKind::given_run:
    case InputKind::document:
      return 64 * mebibyte;
    case InputKind::picture:
      return 256 * mebibyte;
    case InputKind::run_file:
      return 16 * 1024 * mebibyte;
  }
  return 0;
}

FileText read_file_text(const std::string& path, InputKind kind) {
  if (path.find('\0') != std::string::npos) return failed("its name holds a 0 byte");
  struct stat status {};
  // Opening a device may do something to it.
  if (::stat(path.c_str(), &status) != 0) return failed_call();
  if (!S_ISREG(status.st_mode)) return failed(sort_of(status.st_mode));
  const OpenFile file(path);
  if (file < 0 || ::fstat(file, &status) != 0) return failed_call();
  if (!S_ISREG(status.st_mode)) return failed(sort_of(status.st_mode));
  const auto size = static_cast<std::uint64_t>(status.st_size);
  const std::uint64_t most = longest(kind);
  if (size > most)
    return failed(fmt::format("it is longer than {} MiB, the most for its kind", most / mebibyte));
  try {
    return read_open(file, size);
  } catch (const std::bad_alloc&) {
    return failed(fmt::format("there is not enough memory for its {} MiB", size / mebibyte));
  }
}

std::string read_whole_file(const std::string& path, InputKind kind) {
  FileText file = read_file_text(path, kind);
  if (!file.failure.empty())
    throw InputError(one_line(fmt::format("{}: cannot be read: {}", path, file.failure)));
  return std::move(file.text);
}

}  // namespace plumb
