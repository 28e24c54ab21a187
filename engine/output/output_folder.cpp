#include "engine/output/output_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>

#include "engine/errors.h"
#include "engine/interrupt.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw OutputError(path + ": cannot be written: " + reason);
}

bool may_replace(const fs::path& path) {
  if (!fs::exists(path)) return true;
  if (!fs::is_directory(path)) return false;
  if (fs::is_empty(path)) return true;
  for (const char* name : {"run.h5", "study.h5", "study.json"})
    if (fs::exists(path / name)) return true;
  return false;
}

/// Whether a folder lies on another file system than its parent, so that nothing can be renamed to it.
bool is_mount_point(const fs::path& path) {
  struct stat own {
  }, parent{};
  return ::stat(path.c_str(), &own) == 0 && ::stat(path.parent_path().c_str(), &parent) == 0 &&
         own.st_dev != parent.st_dev;
}

/// Removes a folder as far as it can be, and throws nothing.
void remove_for_good(const std::string& path) {
  constexpr int attempts = 2;  // a lack of memory may have passed
  for (int k = 0; k < attempts; ++k) {
    try {
      std::error_code ignored;
      fs::remove_all(path, ignored);
      return;
    } catch (const std::bad_alloc&) {
    }
  }
}

fs::perms current_mask() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return static_cast<fs::perms>(mask);
}

}  // namespace

OutputFolder::OutputFolder(std::string path) : path_(std::move(path)) {
  try {
    // Links are followed first, so that what they point at is replaced and not they.
    fs::path target = fs::weakly_canonical(fs::absolute(path_));
    if (!target.has_filename()) target = target.parent_path();
    if (fs::is_symlink(target)) fail(path_, "it is a link to nothing");
    if (!may_replace(target))
      fail(path_,
           "it exists and is no output folder (it has no run.h5, study.h5 or study.json), so it is left "
           "alone");
    fs::create_directories(target.parent_path());
    if (is_mount_point(target))
      fail(path_, "it is a mount point and cannot be replaced; name a folder in it");
    std::string working =
        (target.parent_path() / ("." + target.filename().string() + ".part-XXXXXX")).string();
    if (::mkdtemp(working.data()) == nullptr) fail(path_, std::strerror(errno));
    fs::permissions(working, fs::perms::all & ~current_mask());
    path_ = target.string();
    working_ = working;
    begin_unfinished(working_);
  } catch (const fs::filesystem_error& error) {
    fail(path_, error.code().message());
  }
}

OutputFolder::~OutputFolder() {
  if (committed_) return;
  remove_for_good(working_);
  end_unfinished(working_);
}

void OutputFolder::keep(const std::string& name) {
  std::error_code error;
  const fs::path old = fs::path(path_) / name;
  if (!fs::is_regular_file(old, error)) return;
  fs::copy_file(old, file(name), error);
  if (error) fail(path_, error.message());
}

std::string OutputFolder::file(const std::string& name) const {
  stop_if_interrupted();
  const fs::path path = fs::path(working_) / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) fail(path.string(), error.message());
  return path.string();
}

void OutputFolder::commit() {
  stop_if_interrupted();
  const Undivided undivided;
  end_unfinished(working_);
  std::error_code error;
  if (fs::exists(path_)) {
    // An exchange leaves no moment without a folder; where the file system has none, two renames do.
    if (::renameat2(AT_FDCWD, working_.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE) == 0) {
      committed_ = true;
      remove_for_good(working_);
      return;
    }
    const std::string old = working_ + ".old";
    fs::rename(path_, old, error);
    if (error) fail(path_, error.message());
    fs::rename(working_, path_, error);
    if (error) {
      std::error_code ignored;
      fs::rename(old, path_, ignored);
      fail(path_, error.message());
    }
    committed_ = true;
    remove_for_good(old);
    return;
  }
  fs::rename(working_, path_, error);
  if (error) fail(path_, error.message());
  committed_ = true;
}

}  // namespace plumb
