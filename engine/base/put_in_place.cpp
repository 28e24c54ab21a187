#include "engine/base/put_in_place.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>
#include <vector>

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Below the temporary folder: what is made, what was taken away, and the manifests that are to come.
const std::string made = std::string(folder_made) + "/", removed = "old/";
constexpr const char* manifest_of_both = "both.json";
constexpr const char* manifest_to_be = "new.json";

[[noreturn]] void fail(int error) {
  throw std::system_error(error, std::generic_category());
}

bool is_not_known_here(int error) {
  return error == EINVAL || error == ENOSYS || error == ENOTSUP;
}

void write_new(PartFolder& part, const std::string& name, const std::string& bytes) {
  Descriptor file = part.create(name);
  if (!file) fail(errno);
  int error = write_all(file.get(), bytes);
  if (error == 0) error = flush_to_disk(file.get());
  if (::close(file.release()) != 0 && error == 0) error = errno;
  if (error != 0) fail(error);
  part.own({{name, listed_as(bytes)}}, "");
}

/// Flushes the folders below an open one that files lie in, and that folder.
void flush_folders(int folder, const ListedFiles& files) {
  std::set<std::string> parents;
  for (const auto& [name, file] : files)
    for (fs::path parent = fs::path(name).parent_path(); !parent.empty(); parent = parent.parent_path())
      parents.insert(parent.string() + "/.");
  parents.insert(".");
  for (const std::string& name : parents) {
    const Beneath place = find_beneath(folder, name);
    if (!place.folder) {
      if (errno == ENOENT) continue;
      fail(errno);
    }
    if (const int error = flush_to_disk(place.folder.get())) fail(error);
  }
}

void flush_files(int folder, const ListedFiles& files) {
  for (const auto& [name, file] : files) {
    const Beneath place = find_beneath(folder, name);
    const Descriptor open(
        place.folder ? ::openat(place.folder.get(), place.name.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC)
                     : -1);
    if (!open) fail(errno);
    if (const int error = flush_to_disk(open.get())) fail(error);
  }
  flush_folders(folder, files);
}

void flush_parent(const std::string& path) {
  const Descriptor parent = open_folder(fs::path(path).parent_path().string());
  if (!parent) fail(errno);
  if (const int error = flush_to_disk(parent.get())) fail(error);
}

int rename_with(unsigned flags, const std::string& from, const std::string& to) {
  return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags) == 0 ? 0 : errno;
}

/// Files moved between two folders, so that all can be moved back.
class Moves {
 public:
  Moves(int part, int folder) : part_(part), folder_(folder) {}

  /// Moves a file of the temporary folder to a name in the other one; what has that name now, if it is
  /// `there`, takes its place. Returns the error number, or 0.
  int put(const std::string& from, const std::string& to, bool there) {
    const Beneath source = find_beneath(part_, from), target = find_beneath(folder_, to, true);
    if (!source.folder || !target.folder) return errno;
    if (!there) return move(source, target, {from, to, Kind::put});
    if (::renameat2(source.folder.get(), source.name.c_str(), target.folder.get(), target.name.c_str(),
                    RENAME_EXCHANGE) == 0) {
      done_.push_back({from, to, Kind::exchanged});
      return 0;
    }
    if (!is_not_known_here(errno)) return errno;
    if (const int error = take(to)) return error;
    return move(source, target, {from, to, Kind::put});
  }

  /// Moves a file of the folder away into the temporary one. Returns the error number, or 0.
  int take(const std::string& name) {
    const std::string to = removed + name;
    const Beneath source = find_beneath(folder_, name), target = find_beneath(part_, to, true);
    if (!source.folder || !target.folder) return errno;
    return move(source, target, {to, name, Kind::taken});
  }

  /// Moves all back, the last first. False if that cannot be done.
  bool undo() {
    bool all = true;
    for (auto step = done_.rbegin(); step != done_.rend(); ++step) {
      const Beneath part = find_beneath(part_, step->part),
                    folder = find_beneath(folder_, step->folder, true);
      const bool out = step->kind == Kind::put;
      const Beneath &from = out ? folder : part, &to = out ? part : folder;
      all =
          (step->kind == Kind::exchanged ? ::renameat2(from.folder.get(), from.name.c_str(), to.folder.get(),
                                                       to.name.c_str(), RENAME_EXCHANGE) == 0
                                         : move(from, to) == 0) &&
          all;
    }
    done_.clear();
    return all;
  }

 private:
  enum class Kind { put, taken, exchanged };
  struct Step {
    std::string part, folder;  ///< names below the two folders
    Kind kind;
  };

  /// Returns the error number, or 0.
  static int move(const Beneath& from, const Beneath& to) {
    if (::renameat2(from.folder.get(), from.name.c_str(), to.folder.get(), to.name.c_str(),
                    RENAME_NOREPLACE) == 0)
      return 0;
    if (!is_not_known_here(errno)) return errno;
    struct stat status {};
    if (::fstatat(to.folder.get(), to.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) return EEXIST;
    return ::renameat(from.folder.get(), from.name.c_str(), to.folder.get(), to.name.c_str()) == 0 ? 0
                                                                                                   : errno;
  }

  int move(const Beneath& from, const Beneath& to, Step step) {
    const int error = move(from, to);
    if (error == 0) done_.push_back(std::move(step));
    return error;
  }

  int part_, folder_;
  std::vector<Step> done_;
};

/// Removes the folders that files lay in, as far as they are empty.
void remove_empty_folders(int folder, const ListedFiles& files) {
  for (const auto& [name, file] : files)
    for (fs::path parent = fs::path(name).parent_path(); !parent.empty(); parent = parent.parent_path()) {
      const Beneath place = find_beneath(folder, parent.string());
      if (!place.folder || ::unlinkat(place.folder.get(), place.name.c_str(), AT_REMOVEDIR) != 0) break;
    }
}

/// Moves files of an open folder and those below it to the same names in another one, where they are free.
void move_files(int from, int to, const std::string& prefix = "") {
  const auto entries = entries_of(from);
  for (const Entry& entry : entries.value_or(std::vector<Entry>())) {
    const std::string name = prefix + entry.name;
    if (entry.folder) {
      const Descriptor below(
          ::openat(from, entry.name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
      if (below) move_files(below.get(), to, name + "/");
    } else if (const Beneath target = find_beneath(to, name, true); target.folder) {
      ::renameat2(from, entry.name.c_str(), target.folder.get(), target.name.c_str(), RENAME_NOREPLACE);
    }
  }
}

}  // namespace

void write_manifest(PartFolder& part, const ListedFiles& written) {
  write_new(part, made + manifest_name, encode_manifest({written}));
}

bool put_at_once(const PlacedFiles& files, const Descriptor& old) {
  const std::string part = files.part.path() + "/" + folder_made;
  write_manifest(files.part, files.written);
  flush_files(files.made, files.written);
  struct stat status {};
  if (old && ::fstat(old.get(), &status) == 0) ::fchmod(files.made, status.st_mode & 07777);
  if (old) ::flock(old.get(), LOCK_EX);
  // Once it is in the temporary folder, what was ours is known to be.
  files.part.own(files.ours, made);
  if (!files.manifest.empty()) files.part.own({{manifest_name, listed_as(files.manifest)}}, made);
  const unsigned flags = old ? RENAME_EXCHANGE : RENAME_NOREPLACE;
  int error = rename_with(flags, part, files.path);
  if (!old && is_not_known_here(error)) error = rename_with(0, part, files.path);
  if (old && is_not_known_here(error)) return false;
  if (error != 0) throw WriteError(files.path, error);
  try {
    flush_parent(files.path);
  } catch (const std::system_error& failure) {
    const std::string fault = failure.code().message();
    if (rename_with(flags, old ? part : files.path, old ? files.path : part) == 0 || !old)
      throw WriteError(files.path, fault);
    files.part.let_go();
    throw WriteError(files.path, fmt::format("{}; what it held is in {}", fault, part));
  }
  if (!old) return true;
  // It is in place: what goes wrong from here on is for a later command to mend.
  try {
    if (files.part.empty()) move_files(old.get(), files.made);
  } catch (const std::exception&) {
  }
  ::flock(old.get(), LOCK_UN);
  return true;
}

void put_one_by_one(const PlacedFiles& files) {
  if (::mkdir(files.path.c_str(), 0777) != 0 && errno != EEXIST) fail(errno);
  const Descriptor folder = open_folder(files.path);
  if (!folder) fail(errno);
  const int part = files.part.descriptor();
  ::flock(folder.get(), LOCK_EX);
  flush_files(files.made, files.written);
  for (const std::string& place : {made, removed}) files.part.own(files.ours, place);
  ListedFiles next = files.kept;
  next.insert(files.written.begin(), files.written.end());

  Moves moves(part, folder.get());
  const auto stop = [&](const std::string& name, const std::string& reason, bool taken) {
    const std::string place = files.part.path(), file = name.empty() ? files.path : files.path + "/" + name;
    const bool back = moves.undo();
    if (!back) files.part.let_go();
    remove_empty_folders(folder.get(), files.written);
    if (!back) throw WriteError(file, fmt::format("{}; what was there is in {}", reason, place));
    if (taken) throw NameTaken(file, reason);
    throw WriteError(file, reason);
  };
  const auto check = [&](const std::string& name, int error) {
    if (error != 0) stop(name, std::generic_category().message(error), error == EEXIST);
  };
  const auto stop_if_changed = [&](const std::string& name, const ListedFile& old, const std::string& taken) {
    if (!is_still(part, taken, old) && !is_still(part, removed + name, old))
      stop(name, "it was changed while it was being replaced", true);
  };
  std::string there = files.manifest;
  const auto put_manifest = [&](const char* name, const Manifest& manifest) {
    const std::string bytes = encode_manifest(manifest);
    write_new(files.part, name, bytes);
    if (!there.empty()) {
      files.part.own({{name, listed_as(there)}}, "");
      files.part.own({{manifest_name, listed_as(there)}}, removed);
    }
    check(manifest_name, moves.put(name, manifest_name, !there.empty()));
    if (!there.empty()) stop_if_changed(manifest_name, listed_as(there), name);
    there = bytes;
  };
  try {
    // From here on each file that has either content is known to be ours, whatever happens.
    put_manifest(manifest_of_both, {files.ours, next});
    flush_folders(folder.get(), {});
    for (const auto& [name, file] : files.written) {
      if (is_still(folder.get(), name, file)) continue;
      const auto old = files.ours.find(name);
      check(name, moves.put(made + name, name, old != files.ours.end()));
      if (old != files.ours.end()) stop_if_changed(name, old->second, made + name);
    }
    for (const auto& [name, file] : files.ours)
      if (!next.contains(name)) {
        check(name, moves.take(name));
        stop_if_changed(name, file, removed + name);
      }
    flush_folders(folder.get(), files.written);
    put_manifest(manifest_to_be, {next});
    flush_folders(folder.get(), {});
  } catch (const std::system_error& error) {
    stop("", error.code().message(), false);
  }
  remove_empty_folders(folder.get(), files.listed);
}

}  // namespace plumb
