#include "engine/output/file_writing.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "engine/errors.h"
#include "engine/interrupt.h"

namespace plumb {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw OutputError(path + ": cannot be written: " + std::strerror(error));
}

/// Writes all bytes and closes the file. Returns the error number, or 0.
int write_and_close(int file, std::string_view bytes) {
  int error = 0;
  while (!bytes.empty() && error == 0) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      error = errno;
  }
  // Some file systems tell of a full disk only now.
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

bool is_regular_or_new(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
}

}  // namespace

void write_file(const std::string& path, std::string_view bytes) {
  if (!is_regular_or_new(path)) {
    const int file = ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (file < 0) fail(path, errno);
    if (const int error = write_and_close(file, bytes)) fail(path, error);
    return;
  }
  std::string part = path + ".part-XXXXXX";
  const int file = ::mkstemp(part.data());
  if (file < 0) fail(path, errno);
  const Unfinished unfinished(part);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(file, 0666 & ~mask);
  int error = write_and_close(file, bytes);
  if (error == 0 && ::rename(part.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(part.c_str());
  fail(path, error);
}

void write_to_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    fail("standard output", errno);
}

}  // namespace plumb
