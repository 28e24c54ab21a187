#include "engine/base/part_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <system_error>

#include "engine/base/file_writing.h"
#include "engine/base/interrupt.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* mark_name = ".plumb-part";
constexpr std::size_t letters = 6, ending = std::string_view(".part-").size();
constexpr off_t longest_mark = off_t{64} << 20;

/// Files of the mark are a record each: a name alone, or how it must be before the name.
std::string record_of(const std::string& name) {
  return fmt::format("any {}{}", name, '\0');
}

std::string record_of(const std::string& name, const ListedFile& file) {
  return fmt::format("{} {} {}{}", file.sha256, file.size, name, '\0');
}

void take_record(const std::string& record, OwnFiles& own) {
  if (record.starts_with("any ")) {
    own[record.substr(4)].clear();
    return;
  }
  const std::size_t first = record.find(' '), second = record.find(' ', first + 1);
  if (first == std::string::npos || second == std::string::npos) return;
  const std::string sum = record.substr(0, first);
  own[record.substr(second + 1)].push_back({std::strtoull(record.c_str() + first, nullptr, 10), sum});
}

[[noreturn]] void fail() {
  throw std::system_error(errno, std::generic_category());
}

/// A copy of the folder is another folder, and not ours.
std::string mark_of(const struct stat& folder) {
  return fmt::format("temporary folder {} of Plumb\n", folder.st_ino);
}

/// What the mark of a folder says is ours; nothing where it has none of ours.
std::optional<OwnFiles> files_by_mark(int folder) {
  struct stat status {};
  if (::fstat(folder, &status) != 0) return {};
  const Descriptor file(::openat(folder, mark_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  const std::string wanted = mark_of(status);
  struct stat found {};
  if (!file || ::fstat(file.get(), &found) != 0 || !S_ISREG(found.st_mode) || found.st_size > longest_mark)
    return {};
  std::string text(static_cast<std::size_t>(found.st_size), '\0');
  if (::read(file.get(), text.data(), text.size()) != found.st_size || !text.starts_with(wanted)) return {};
  OwnFiles own;
  // One that was cut off has no end.
  for (std::size_t from = wanted.size(), end; (end = text.find('\0', from)) != std::string::npos;
       from = end + 1)
    take_record(text.substr(from, end - from), own);
  return own;
}

/// As one has that was killed before it wrote its mark; nothing is lost with it.
bool holds_an_empty_mark_alone(int folder) {
  const auto entries = entries_of(folder);
  struct stat status {};
  return entries && entries->size() == 1 && entries->front().file && entries->front().name == mark_name &&
         ::fstatat(folder, mark_name, &status, AT_SYMLINK_NOFOLLOW) == 0 && status.st_size == 0;
}

/// Removes the files below an open folder that are ours, and the folders that are empty then. False if one of
/// them is still there, or may be.
bool remove_ours(int folder, const std::string& prefix,
                 const std::function<bool(const std::string& name)>& is_ours) {
  const auto entries = entries_of(folder);
  bool all = entries.has_value();
  for (const Entry& entry : entries.value_or(std::vector<Entry>())) {
    const std::string name = prefix + entry.name;
    if (entry.folder) {
      const Descriptor below(
          ::openat(folder, entry.name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
      all = below && remove_ours(below.get(), name + "/", is_ours) && all;
      ::unlinkat(folder, entry.name.c_str(), AT_REMOVEDIR);
    } else if (entry.file && is_ours(name)) {
      all = (::unlinkat(folder, entry.name.c_str(), 0) == 0 || errno == ENOENT) && all;
    }
  }
  return all;
}

/// Empties an open folder as far as it is ours.
bool empty_of(int folder, const OwnFiles& own) {
  return remove_ours(folder, "", [&](const std::string& name) {
    const auto file = own.find(name);
    return file != own.end() && (file->second.empty() || std::any_of(file->second.begin(), file->second.end(),
                                                                     [&](const ListedFile& listed) {
                                                                       return is_still(folder, name, listed);
                                                                     }));
  });
}

/// A file in an open folder, but for the mark; "" where there is none.
std::string first_file_in(int folder, const std::string& prefix = "") {
  const auto entries = entries_of(folder);
  if (!entries) fail();
  for (const Entry& entry : *entries) {
    if (prefix.empty() && entry.name == mark_name) continue;
    if (!entry.folder) return prefix + entry.name;
    const Descriptor below(
        ::openat(folder, entry.name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    const std::string first =
        below ? first_file_in(below.get(), prefix + entry.name + "/") : prefix + entry.name;
    if (!first.empty()) return first;
  }
  return "";
}

/// What the folder is called if something of others is left in it.
std::string visible_name(const std::string& path) {
  const fs::path place = path;
  const std::string name = place.filename().string();
  return (place.parent_path() / (name.substr(1, name.size() - 1 - ending - letters) + ".new")).string();
}

/// Removes such a folder as far as it is ours. Returns the first file that is left where it is now; nothing
/// where it is gone. Throws std::system_error where it cannot be known what is ours: all that is left is as
/// it was then, for a later command.
std::string clear_folder(const std::string& path, int folder, const OwnFiles& own) {
  if (!empty_of(folder, own)) throw std::system_error(EBUSY, std::generic_category());
  const std::string left = first_file_in(folder);
  if (::unlinkat(folder, mark_name, 0) != 0 && errno != ENOENT) fail();
  if (::rmdir(path.c_str()) == 0 || errno == ENOENT) return "";
  if (left.empty()) fail();
  const std::string place = move_aside(path, visible_name(path));
  return (place.empty() ? path : place) + "/" + left;
}

/// Where the program is ended from outside, while its work goes on.
void clear_unfinished(const std::string& path) {
  try {
    const Descriptor folder = open_folder(path);
    const std::optional<OwnFiles> own = folder ? files_by_mark(folder.get()) : std::nullopt;
    if (own) clear_folder(path, folder.get(), *own);
  } catch (const std::exception&) {
    // The next command may have more luck.
  }
}

}  // namespace

PartFolder::PartFolder(const std::string& parent, const std::string& name) {
  const fs::path pattern = fs::path(parent) / ("." + name + ".part-" + std::string(letters, 'X'));
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
  try {
    mark_ = Descriptor(
        ::openat(folder_.get(), mark_name, O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666));
    if (!mark_ || !note(mark_of(status))) fail();
    begin_unfinished(path_, clear_unfinished);
  } catch (const std::exception&) {
    ::unlinkat(folder_.get(), mark_name, 0);
    ::rmdir(path_.c_str());
    throw;
  }
}

PartFolder::~PartFolder() {
  constexpr int attempts = 2;  // what failed once, as for want of memory, may have passed
  for (int k = 0; k < attempts && !path_.empty(); ++k) {
    try {
      clear();
    } catch (const std::exception&) {
      // What cannot be read is not known to be ours: it stays, with the mark, for the next command to clear.
    }
  }
  if (!path_.empty()) end_unfinished(path_);
}

/// One that was cut off ends what is known of the folder.
bool PartFolder::note(const std::string& records) {
  const int error = write_all(mark_.get(), records);
  errno = error;
  return error == 0;
}

Descriptor PartFolder::create(const std::string& name) {
  // Once what is unfinished is being removed, nothing may come after it.
  const Undivided undivided;
  if (!note(record_of(name))) return {};
  own_[name].clear();
  const Beneath place = find_beneath(folder_.get(), name, true);
  if (!place.folder) return {};
  return Descriptor(::openat(place.folder.get(), place.name.c_str(),
                             O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666));
}

void PartFolder::own(const std::string& name) {
  if (!note(record_of(name))) fail();
  own_[name].clear();
}

void PartFolder::own(const ListedFiles& files, const std::string& prefix) {
  std::string records;
  for (const auto& [name, file] : files) records += record_of(prefix + name, file);
  if (!note(records)) fail();
  for (const auto& [name, file] : files) own_[prefix + name].push_back(file);
}

bool PartFolder::empty() {
  return empty_of(folder_.get(), own_);
}

std::string PartFolder::clear() {
  mark_ = {};  // where a process may have no more descriptors, to look into the folder takes this one
  const std::string left = clear_folder(path_, folder_.get(), own_);
  let_go();
  return left;
}

void PartFolder::let_go() {
  end_unfinished(path_);
  path_.clear();
}

std::string move_aside(const std::string& from, const std::string& path) {
  constexpr int most = 1000;
  for (int k = 1; k < most; ++k) {
    const std::string place = k == 1 ? path : fmt::format("{}-{}", path, k);
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, place.c_str(), RENAME_NOREPLACE) == 0) return place;
    if (errno != EEXIST) break;
  }
  return "";
}

Leftovers clear_leftovers(const std::string& parent, const std::string& name) {
  Leftovers leftovers;
  const Descriptor folder = open_folder(parent);
  if (!folder) return leftovers;
  const std::string beginning = "." + name + ".part-";
  const auto entries = entries_of(folder.get());
  for (const Entry& entry : entries.value_or(std::vector<Entry>())) {
    if (!entry.folder || !entry.name.starts_with(beginning) ||
        entry.name.size() != beginning.size() + letters)
      continue;
    const std::string path = (fs::path(parent) / entry.name).string();
    const Descriptor part = open_folder(path);
    if (!part || ::flock(part.get(), LOCK_EX | LOCK_NB) != 0) continue;
    try {
      std::optional<OwnFiles> own = files_by_mark(part.get());
      if (!own && holds_an_empty_mark_alone(part.get())) own.emplace();
      if (!own) continue;
      const std::string left = clear_folder(path, part.get(), *own);
      ++leftovers.cleared;
      if (!left.empty()) leftovers.kept.push_back(left);
    } catch (const std::system_error&) {
      // The next one may have more luck.
    }
  }
  return leftovers;
}

}  // namespace plumb
