#include "engine/output/part_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "engine/interrupt.h"
#include "engine/output/manifest.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* mark_name = ".plumb-part";
constexpr std::size_t letters = 6;

[[noreturn]] void fail() {
  throw std::system_error(errno, std::generic_category());
}

mode_t allowed_mode(mode_t all) {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return all & ~mask;
}

/// A copy of the folder is another folder, and not ours.
std::string mark_of(const struct stat& folder) {
  return fmt::format("temporary folder {} of Plumb\n", folder.st_ino);
}

bool has_mark(int folder) {
  struct stat status {};
  if (::fstat(folder, &status) != 0) return false;
  const Descriptor file(::openat(folder, mark_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  const std::string wanted = mark_of(status);
  struct stat found {};
  if (!file || ::fstat(file.get(), &found) != 0 || !S_ISREG(found.st_mode)) return false;
  std::string text(wanted.size() + 1, '\0');
  const ssize_t count = ::read(file.get(), text.data(), text.size());
  return count == static_cast<ssize_t>(wanted.size()) && text.starts_with(wanted);
}

struct Entry {
  std::string name;
  bool folder = false, file = false;
};

std::vector<Entry> entries_of(int folder) {
  std::vector<Entry> entries;
  Descriptor copy(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  DIR* list = copy ? ::fdopendir(copy.get()) : nullptr;
  if (list == nullptr) return entries;
  copy.release();  // closed with the list
  while (const dirent* entry = ::readdir(list)) {
    const std::string name = entry->d_name;
    struct stat status {};
    if (name == "." || name == ".." || ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
      continue;
    entries.push_back({name, S_ISDIR(status.st_mode), S_ISREG(status.st_mode)});
  }
  ::closedir(list);
  return entries;
}

/// As one has that was killed before it wrote its mark; nothing is lost with it.
bool holds_an_empty_mark_alone(int folder) {
  const std::vector<Entry> entries = entries_of(folder);
  struct stat status {};
  return entries.size() == 1 && entries[0].file && entries[0].name == mark_name &&
         ::fstatat(folder, mark_name, &status, AT_SYMLINK_NOFOLLOW) == 0 && status.st_size == 0;
}

/// Removes the files below an open folder that are ours, and the folders that are empty then. False if one of
/// them is still there.
bool remove_ours(int folder, const std::string& prefix,
                 const std::function<bool(const std::string& name)>& is_ours) {
  bool all = true;
  for (const Entry& entry : entries_of(folder)) {
    const std::string name = prefix + entry.name;
    if (entry.folder) {
      const Descriptor below(
          ::openat(folder, entry.name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
      all = below && remove_ours(below.get(), name + "/", is_ours) && all;
      ::unlinkat(folder, entry.name.c_str(), AT_REMOVEDIR);
    } else if (entry.file && is_ours(name)) {
      all = ::unlinkat(folder, entry.name.c_str(), 0) == 0 && all;
    }
  }
  return all;
}

/// Empties the folder of a killed program as far as it is ours.
void empty_leftover(int folder, const std::function<bool(std::string_view)>& is_ours) {
  const FoundManifest found = find_manifest(folder);
  const bool marked = has_mark(folder) || holds_an_empty_mark_alone(folder);
  remove_ours(folder, "", [&](const std::string& name) {
    if (marked && name != mark_name && (name == manifest_name || is_ours(name))) return true;
    for (const ListedFiles* list : {&found.manifest.files, &found.manifest.next})
      if (const auto listed = list->find(name); listed != list->end())
        return is_still(folder, name, listed->second);
    return false;
  });
  // What tells whose it is goes last.
  std::vector<Entry> left = entries_of(folder);
  std::erase_if(left, [&](const Entry& entry) {
    return (marked && entry.name == mark_name) ||
           (entry.name == manifest_name && found.there && found.fault.empty());
  });
  if (!left.empty()) return;
  if (found.there && found.fault.empty()) ::unlinkat(folder, manifest_name, 0);
  if (marked) ::unlinkat(folder, mark_name, 0);
}

}  // namespace

PartFolder::PartFolder(const std::string& parent, const std::string& name) {
  const fs::path pattern = fs::path(parent) / ("." + name + ".part-" + std::string(letters, 'X'));
  visible_ = (fs::path(parent) / (name + ".new")).string();
  struct stat status {};
  do {
    path_ = pattern.string();
    if (::mkdtemp(path_.data()) == nullptr) fail();
    folder_ = open_folder(path_);
    if (!folder_ && errno != ENOENT) {
      const int error = errno;
      ::rmdir(path_.c_str());
      errno = error;
      fail();
    }
    // One that clears up may have taken it for a leftover until it is locked.
    if (folder_) ::flock(folder_.get(), LOCK_EX);
  } while (!folder_ || ::fstat(folder_.get(), &status) != 0 || status.st_nlink == 0);
  const Descriptor mark(::openat(folder_.get(), mark_name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  const std::string text = mark_of(status);
  if (mark && ::write(mark.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
      ::fchmod(folder_.get(), allowed_mode(0777)) == 0) {
    begin_unfinished(path_);
    return;
  }
  const int error = errno;
  ::unlinkat(folder_.get(), mark_name, 0);
  ::rmdir(path_.c_str());
  errno = error;
  fail();
}

PartFolder::~PartFolder() {
  if (path_.empty()) return;
  end_unfinished(path_);
  constexpr int attempts = 2;  // what failed once, as for want of memory, may have passed
  for (int k = 0; k < attempts; ++k) {
    try {
      const bool emptied = remove_ours(folder_.get(), "", [&](const std::string& name) {
        return name != mark_name && (!is_ours_ || is_ours_(name));
      });
      if (!emptied || (::unlinkat(folder_.get(), mark_name, 0) != 0 && errno != ENOENT)) continue;
      if (::rmdir(path_.c_str()) == 0) return;
      // What is left now is not ours, and its owner should see it.
      if (errno == ENOTEMPTY)
        ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, visible_.c_str(), RENAME_NOREPLACE);
    } catch (const std::exception&) {
      // What cannot be read is not known to be ours: it stays, with the mark, for the next command to clear.
    }
  }
}

void PartFolder::let_go() {
  end_unfinished(path_);
  path_.clear();
}

void PartFolder::unmark() {
  if (::unlinkat(folder_.get(), mark_name, 0) != 0 && errno != ENOENT) fail();
}

bool clear_leftover(const std::string& path, const std::function<bool(std::string_view)>& is_ours) {
  const Descriptor folder = open_folder(path);
  if (!folder || ::flock(folder.get(), LOCK_EX | LOCK_NB) != 0) return false;
  try {
    empty_leftover(folder.get(), is_ours);
  } catch (const std::system_error&) {
    return false;  // the next one may have more luck
  }
  return ::rmdir(path.c_str()) == 0;
}

int clear_leftovers(const std::string& parent, const std::string& name,
                    const std::function<bool(std::string_view)>& is_ours) {
  int cleared = 0;
  const Descriptor folder = open_folder(parent);
  if (!folder) return cleared;
  const std::string beginning = "." + name + ".part-";
  for (const Entry& entry : entries_of(folder.get())) {
    if (!entry.folder || !entry.name.starts_with(beginning) ||
        entry.name.size() != beginning.size() + letters)
      continue;
    if (clear_leftover((fs::path(parent) / entry.name).string(), is_ours)) ++cleared;
  }
  return cleared;
}

}  // namespace plumb
