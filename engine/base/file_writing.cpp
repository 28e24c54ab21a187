#include "engine/base/file_writing.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "engine/base/beneath.h"
#include "engine/base/part_folder.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

void write_as_it_is(const std::string& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  if (file < 0) throw WriteError(path, errno);
  int error = write_all(file, bytes);
  // Some file systems tell of a full disk only now.
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0) throw WriteError(path, error);
}

/// Writes a new file beside the one that it is to replace. Returns the error number, or 0.
int replace(const fs::path& place, std::string_view bytes) {
  const fs::path parent = place.has_parent_path() ? place.parent_path() : fs::path(".");
  const std::string name = place.filename().string();
  clear_leftovers(parent.string(), name);
  PartFolder part(parent.string(), name);
  Descriptor file = part.create(name);
  if (!file) return errno;
  struct stat old {};
  if (::stat(place.c_str(), &old) == 0) ::fchmod(file.get(), old.st_mode & 0777);
  int error = write_all(file.get(), bytes);
  if (error == 0) error = flush_to_disk(file.get());
  if (::close(file.release()) != 0 && error == 0) error = errno;
  if (error == 0 && ::renameat(part.descriptor(), name.c_str(), AT_FDCWD, place.c_str()) != 0) error = errno;
  return error;
}

}  // namespace

WriteError::WriteError(const std::string& path, const std::string& reason)
    : OutputError(path + ": cannot be written: " + reason) {}

WriteError::WriteError(const std::string& path, int error)
    : WriteError(path, std::generic_category().message(error)) {}

int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

std::string place_of_file(const std::string& path) {
  constexpr int most_links = 40;
  fs::path place = path;
  std::error_code error;
  for (int k = 0; k < most_links && fs::is_symlink(place, error); ++k) {
    const fs::path parent = fs::canonical(fs::absolute(place).parent_path(), error);
    // A link of the process file system stands for an open file, which has no name to be replaced.
    if (error || *++parent.begin() == "proc") return "";
    place = (parent / fs::read_symlink(place, error)).lexically_normal();
    if (error) return "";
  }
  const fs::file_status status = fs::symlink_status(place, error);
  return status.type() == fs::file_type::regular || status.type() == fs::file_type::not_found ? place.string()
                                                                                              : "";
}

void write_file(const std::string& path, std::string_view bytes) {
  const std::string place = place_of_file(path);
  if (place.empty()) return write_as_it_is(path, bytes);
  int error = 0;
  try {
    error = replace(place, bytes);
  } catch (const std::system_error& failure) {
    error = failure.code().value();
  }
  if (error != 0) throw WriteError(path, error);
}

void write_to_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw WriteError("standard output", errno);
}

}  // namespace plumb
