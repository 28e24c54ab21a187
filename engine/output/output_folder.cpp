#include "engine/output/output_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "engine/errors.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw OutputError(path + ": cannot be written: " + reason);
}

bool may_replace(const fs::path& path) {
  return !fs::exists(path) || (fs::is_directory(path) && (fs::is_empty(path) || fs::exists(path / "run.h5")));
}

}  // namespace

OutputFolder::OutputFolder(std::string path) : path_(std::move(path)) {
  try {
    fs::path target = fs::absolute(path_).lexically_normal();
    if (!target.has_filename()) target = target.parent_path();
    if (!may_replace(target))
      fail(path_, "it exists and is no output folder (it has no run.h5), so it is left alone");
    fs::create_directories(target.parent_path());
    const fs::path working =
        target.parent_path() / ("." + target.filename().string() + ".part-" + std::to_string(::getpid()));
    fs::remove_all(working);
    fs::create_directory(working);
    path_ = target.string();
    working_ = working.string();
  } catch (const fs::filesystem_error& error) {
    fail(path_, error.code().message());
  }
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(working_, ignored);
}

void OutputFolder::start_from(const std::string& folder) {
  try {
    fs::copy(folder, working_, fs::copy_options::recursive);
  } catch (const fs::filesystem_error& error) {
    fail(path_, error.code().message());
  }
}

std::string OutputFolder::file(const std::string& name) const {
  const fs::path path = fs::path(working_) / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) fail(path.string(), error.message());
  return path.string();
}

void OutputFolder::commit() {
  std::error_code error;
  if (fs::exists(path_)) {
    // An exchange leaves no moment without a folder; where the file system has none, two renames do.
    if (::renameat2(AT_FDCWD, working_.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE) == 0) {
      committed_ = true;
      fs::remove_all(working_, error);
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
    fs::remove_all(old, error);
    return;
  }
  fs::rename(working_, path_, error);
  if (error) fail(path_, error.message());
  committed_ = true;
}

}  // namespace plumb
