#include "engine/output/file_writing.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "engine/errors.h"

namespace plumb {

void write_file(const std::string& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const auto fail = [&](int error) {
    if (file >= 0) ::unlink(path.c_str());
    throw OutputError(path + ": cannot be written: " + std::strerror(error));
  };
  if (file < 0) fail(errno);
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int error = errno;
      ::close(file);
      fail(error);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  // Some file systems tell of a full disk only now.
  if (::close(file) != 0) fail(errno);
}

}  // namespace plumb
