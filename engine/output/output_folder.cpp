#include "engine/output/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "engine/errors.h"
#include "engine/interrupt.h"
#include "engine/output/file_writing.h"
#include "engine/output/put_in_place.h"
#include "engine/output/sha256.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// The folder at the end of all links. Throws OutputError if it is none.
fs::path folder_at(const std::string& path) {
  fs::path target = fs::weakly_canonical(fs::absolute(path));
  if (!target.has_filename()) target = target.parent_path();
  if (fs::is_symlink(target)) throw WriteError(path, "it is a link to nothing");
  if (fs::exists(target) && !fs::is_directory(target)) throw WriteError(path, "it is no folder");
  return target;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// Whether the program stands in the folder or below it.
bool is_stood_in(const fs::path& folder) {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  return !error && is_below(here, folder);
}

/// Whether a folder can be exchanged for another one beside it.
bool has_room_beside(const fs::path& folder) {
  struct stat own {
  }, parent{};
  return ::stat(folder.parent_path().c_str(), &parent) == 0 &&
         ::access(folder.parent_path().c_str(), W_OK) == 0 &&
         (::stat(folder.c_str(), &own) != 0 || own.st_dev == parent.st_dev);
}

}  // namespace

OutputFolder::OutputFolder(const std::string& path, FolderUse use)
    : OutputFolder(path, std::move(use), false) {}

void OutputFolder::check(const std::string& path, const FolderUse& use) {
  OutputFolder(path, use, true);
}

OutputFolder::OutputFolder(const std::string& path, FolderUse use, bool only_checks) : use_(std::move(use)) {
  const auto say = [&](const std::string& text) {
    if (use_.remark && !only_checks) use_.remark(text);
  };
  try {
    const fs::path target = folder_at(path);
    path_ = target.string();
    const std::string name = target.filename().string();
    if (!only_checks) {
      const auto is_ours = [&](std::string_view file) { return is_made_on_the_way(use_.content, file); };
      const int cleared = clear_leftovers(target.parent_path().string(), name, is_ours) +
                          clear_leftovers(path_, name, is_ours);
      if (cleared > 0)
        say(fmt::format("cleared what {} that did not end left beside {}",
                        cleared == 1 ? "an earlier command" : fmt::format("{} earlier commands", cleared),
                        path));
    }
    const FolderSurvey survey = look();
    refuse_conflicts(survey);
    ours_ = survey.ours;
    began_with_ = survey.manifest;
    if (!survey.manifest.manifest.next.empty())
      say(fmt::format(
          "an earlier command was killed while it put its files into {}: what is there may be of two", path));
    if (only_checks) return;
    fs::create_directories(target.parent_path());
    const bool inside = survey.folder && (!survey.others.empty() || !has_room_beside(target));
    part_ = std::make_unique<PartFolder>(inside ? path_ : target.parent_path().string(), name);
    // What others put into it stays; what lay in the old folder and was taken away is ours by its sum.
    part_->own([this, folder = part_->descriptor()](const std::string& file) {
      const std::string old = file.starts_with("removed/") ? file.substr(8) : file;
      const auto is_as_in = [&](const ListedFiles& list, const std::string& as) {
        const auto listed = list.find(as);
        return listed != list.end() && is_still(folder, file, listed->second);
      };
      if (file == being_written_ || is_as_in(written_, file) || is_as_in(ours_, old)) return true;
      return file == "both.json" || file == "new.json" ||
             (file == manifest_name && find_manifest(folder).fault.empty());
    });
  } catch (const std::system_error& error) {
    throw WriteError(path, error.code().message());
  }
}

OutputFolder::~OutputFolder() {
  part_.reset();  // before what tells what of it is ours
}

FolderSurvey OutputFolder::look() const {
  FolderSurvey survey = look_into(path_, use_.content);
  if (part_) survey.others.erase(fs::path(part_->path()).filename().string());
  return survey;
}

bool OutputFolder::is_source(const std::string& name) const {
  struct stat file {
  }, source{};
  return ::stat((fs::path(path_) / name).c_str(), &file) == 0 &&
         std::any_of(use_.sources.begin(), use_.sources.end(), [&](const std::string& path) {
           return ::stat(path.c_str(), &source) == 0 && source.st_dev == file.st_dev &&
                  source.st_ino == file.st_ino;
         });
}

void OutputFolder::refuse_conflicts(const FolderSurvey& survey) const {
  if (!survey.folder) return;
  if (!survey.manifest.fault.empty())
    throw WriteError(
        path_ + "/" + manifest_name,
        survey.manifest.fault + ", so nothing in its folder is taken for ours; name another folder with -o");
  for (const std::string& name : survey.others) {
    if (is_source(name)) continue;
    if (!survey.manifest.there && !use_.beside_others)
      throw WriteError(path_, fmt::format("it holds {} and no {} of Plumb, so it is left alone; name another "
                                          "folder with -o",
                                          name, manifest_name));
    if (use_.content != FolderContent::copies &&
        (belongs_to(use_.content, name) || belongs_to(use_.content, name + "/0000.png")))
      refuse(name, survey.manifest.manifest.files.contains(name));
  }
  for (const std::string& path : use_.reads) {
    struct stat read {
    }, own{};
    if (::stat(path.c_str(), &read) != 0) continue;
    for (const auto& [name, file] : survey.ours)
      if (::stat((fs::path(path_) / name).c_str(), &own) == 0 && own.st_dev == read.st_dev &&
          own.st_ino == read.st_ino)
        throw UsageError(fmt::format(
            "{}: is read, and would be replaced by the new {}; name another folder with -o", path, path_));
  }
}

void OutputFolder::refuse(const std::string& name, bool changed) const {
  throw WriteError(path_ + "/" + name,
                   changed
                       ? "it was changed since Plumb wrote it, so it is left alone; move it away, or name "
                         "another folder with -o"
                       : "that name is taken by a file that is not Plumb's, so it is left alone; move it "
                         "away, or name another folder with -o");
}

void OutputFolder::refuse_taken_names(const FolderSurvey& survey) {
  if (!survey.folder) return;
  for (auto file = written_.begin(); file != written_.end();) {
    const auto& [name, listed] = *file;
    struct stat status {};
    const Beneath place = find_beneath(survey.folder.get(), name);
    if (!place.folder && errno != ENOENT && errno != ENOTDIR && errno != ELOOP)
      throw std::system_error(errno, std::generic_category());
    const bool there =
        place.folder ? ::fstatat(place.folder.get(), place.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0
                     : errno != ENOENT;
    if (!there || survey.ours.contains(name) || is_still(survey.folder.get(), name, listed)) {
      ++file;
    } else if (is_source(name)) {
      ::unlinkat(part_->descriptor(), name.c_str(), 0);
      file = written_.erase(file);
    } else {
      refuse(name, survey.manifest.manifest.files.contains(name));
    }
  }
}

/// One that came or was changed while the work was done may be somebody else's.
void OutputFolder::refuse_other_manifest(const FolderSurvey& survey) const {
  if (!survey.manifest.there) return;
  if (!began_with_.there) refuse(manifest_name, false);
  if (!survey.manifest.fault.empty() || survey.manifest.text != began_with_.text) refuse(manifest_name, true);
}

void OutputFolder::fail(const std::string& name, int error) const {
  throw WriteError(name.empty() ? path_ : path_ + "/" + name, error);
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  if (!is_name_beneath(name) || !belongs_to(use_.content, name))
    throw std::logic_error(name + " is no file of an output folder");
  put(name, bytes);
}

void OutputFolder::put(const std::string& name, std::string_view bytes) {
  being_written_ = name;
  const Beneath place = find_beneath(part_->descriptor(), name, true);
  const int file = place.folder ? ::openat(place.folder.get(), place.name.c_str(),
                                           O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666)
                                : -1;
  if (file < 0) fail(name, errno);
  int error = write_all(file, bytes);
  // Starts on the way to the disk what commit() waits for.
  if (error == 0) ::sync_file_range(file, 0, 0, SYNC_FILE_RANGE_WRITE);
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0) fail(name, error);
  written_[name] = {bytes.size(), sha256(bytes)};
  being_written_.clear();
}

std::string OutputFolder::read(const std::string& name) const {
  const auto file = written_.find(name);
  const std::optional<std::string> bytes =
      file != written_.end() ? bytes_of(part_->descriptor(), name, file->second) : std::nullopt;
  if (!bytes) throw WriteError(path_ + "/" + name, "it is not what was written");
  return *bytes;
}

void OutputFolder::keep(const std::string& name) {
  const auto file = ours_.find(name);
  const Descriptor folder = open_folder(path_);
  if (file == ours_.end() || !folder) return;
  if (const auto bytes = bytes_of(folder.get(), name, file->second)) put(name, *bytes);
}

void OutputFolder::commit() {
  stop_if_interrupted();
  const Undivided undivided;
  try {
    const FolderSurvey survey = look();
    try {
      refuse_other_manifest(survey);
      refuse_taken_names(survey);
    } catch (const OutputError& error) {
      throw OutputError(error.what() + set_aside());
    }
    PlacedFiles files{*part_, path_, written_};
    const bool fresh =
        !survey.folder || (survey.ours.empty() && survey.others.empty() && !survey.manifest.there);
    const bool beside = fs::path(part_->path()).parent_path() == fs::path(path_).parent_path();
    if (!(beside && survey.others.empty() && !is_stood_in(path_) && (fresh || !use_.adds)) ||
        !put_at_once(files, survey.folder, use_.content)) {
      if (use_.adds) files.kept = survey.ours;
      for (const auto& [name, listed] : written_) files.kept.erase(name);
      files.ours = survey.ours;
      files.listed = survey.manifest.manifest.all();
      put_one_by_one(files);
    }
  } catch (const std::system_error& error) {
    throw WriteError(path_, error.code().message());
  }
  part_.reset();
}

std::string OutputFolder::set_aside() {
  const std::string place = path_ + ".new";
  try {
    write_manifest(part_->descriptor(), {written_});
    part_->unmark();
  } catch (const std::system_error&) {
    return "";
  }
  if (::renameat2(AT_FDCWD, part_->path().c_str(), AT_FDCWD, place.c_str(), RENAME_NOREPLACE) != 0) return "";
  part_->let_go();
  return fmt::format("; what was made is in {}", place);
}

}  // namespace plumb
