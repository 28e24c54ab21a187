#include "engine/run/output_folder.h"

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

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/interrupt.h"
#include "engine/base/put_in_place.h"
#include "engine/base/sha256.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// The folder at the end of all links. Throws OutputError if it is none.
fs::path folder_at(const std::string& path) {
  const fs::path whole = fs::absolute(path);
  fs::path upwards;
  for (const fs::path& part : whole) {
    upwards /= part;
    if (fs::is_symlink(upwards) && !fs::exists(upwards))
      throw WriteError(path,
                       fmt::format("{} is a link to nothing, {}", upwards == whole ? "it" : upwards.string(),
                                   fs::read_symlink(upwards).string()));
    if (fs::exists(upwards) && !fs::is_directory(upwards))
      throw WriteError(path, fmt::format("{} is no folder", upwards == whole ? "it" : upwards.string()));
  }
  fs::path target = fs::weakly_canonical(whole);
  if (!target.has_filename()) target = target.parent_path();
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
    if (!only_checks) clear_leftovers_of(path, use_.remark);
    const FolderSurvey survey = look();
    refuse_conflicts(survey);
    ours_ = survey.ours;
    began_with_ = survey.manifest;
    if (!survey.manifest.manifest.next.empty())
      say(fmt::format(
          "an earlier command was killed while it put its files into {}: what is there may be of two", path));
    if (survey.folder && ::access(path_.c_str(), W_OK) != 0) throw WriteError(path, errno);
    if (only_checks) return;
    fs::create_directories(target.parent_path());
    const bool inside = survey.folder && (!survey.others.empty() || !has_room_beside(target));
    part_ = std::make_unique<PartFolder>(inside ? path_ : target.parent_path().string(), name);
    if (::mkdirat(part_->descriptor(), folder_made, 0777) != 0) throw WriteError(path, errno);
    made_ = open_folder(part_->path() + "/" + folder_made);
    if (!made_) throw WriteError(path, errno);
  } catch (const std::system_error& error) {
    throw WriteError(path, error.code().message());
  }
}

OutputFolder::~OutputFolder() = default;

FolderSurvey OutputFolder::look() const {
  FolderSurvey survey = look_into(path_, use_.content, use_.formats);
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
        (belongs_to(use_.content, name, use_.formats) || belongs_to(use_.content, name + "/0000.png")))
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
  throw NameTaken(path_ + "/" + name,
                  changed ? "it was changed since Plumb wrote it, so it is left alone; move it away, or name "
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
      ::unlinkat(made_.get(), name.c_str(), 0);
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
  if (!is_name_beneath(name) || !belongs_to(use_.content, name, use_.formats))
    throw std::logic_error(name + " is no file of an output folder");
  put(name, bytes);
}

bool OutputFolder::holds(const std::string& name) const {
  const std::lock_guard lock(writing_);
  return part_ != nullptr && written_.contains(name);
}

void OutputFolder::put(const std::string& name, std::string_view bytes) {
  const std::lock_guard lock(writing_);
  const std::string place = std::string(folder_made) + "/";
  Descriptor file = part_->create(place + name);
  if (!file) fail(name, errno);
  int error = write_all(file.get(), bytes);
  // Starts on the way to the disk what commit() waits for.
  if (error == 0) ::sync_file_range(file.get(), 0, 0, SYNC_FILE_RANGE_WRITE);
  if (::close(file.release()) != 0 && error == 0) error = errno;
  if (error != 0) fail(name, error);
  const ListedFile& listed = written_[name] = {bytes.size(), sha256(bytes)};
  try {
    part_->own({{name, listed}}, place);
  } catch (const std::system_error& failure) {
    fail(name, failure.code().value());
  }
}

std::string OutputFolder::read(const std::string& name) const {
  const std::lock_guard lock(writing_);
  const auto file = written_.find(name);
  const std::optional<std::string> bytes =
      file != written_.end() ? bytes_of(made_.get(), name, file->second) : std::nullopt;
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
    place();
  } catch (const NameTaken& error) {
    throw OutputError(error.what() + set_aside());
  } catch (const std::system_error& error) {
    throw WriteError(path_, error.code().message());
  }
  try {
    const std::string kept = part_->clear();
    if (!kept.empty() && use_.remark)
      use_.remark(fmt::format("{} came into {} while it was replaced: it is kept there", kept, path_));
  } catch (const std::exception&) {
    // All is in place, and what could not be cleared is so by a later command.
  }
  part_.reset();
}

void OutputFolder::place() {
  const FolderSurvey survey = look();
  refuse_other_manifest(survey);
  refuse_taken_names(survey);
  PlacedFiles files{*part_, made_.get(), path_, written_, survey.manifest.text, survey.ours};
  const bool fresh =
      !survey.folder || (survey.ours.empty() && survey.others.empty() && !survey.manifest.there);
  const bool beside = fs::path(part_->path()).parent_path() == fs::path(path_).parent_path();
  if (beside && survey.others.empty() && !is_stood_in(path_) && (fresh || !use_.adds) &&
      put_at_once(files, survey.folder))
    return;
  if (use_.adds) files.kept = survey.ours;
  for (const auto& [name, listed] : written_) files.kept.erase(name);
  files.listed = survey.manifest.manifest.all();
  put_one_by_one(files);
}

std::string OutputFolder::set_aside() {
  try {
    if (part_->path().empty()) return "";
    write_manifest(*part_, written_);
    const std::string place = move_aside(part_->path() + "/" + folder_made, path_ + ".new");
    return place.empty() ? "" : "; what was made is in " + place;
  } catch (const std::system_error&) {
    return "";
  }
}

void clear_leftovers_of(const std::string& path, const std::function<void(const std::string&)>& remark) {
  const fs::path place = fs::weakly_canonical(fs::absolute(path));
  const fs::path target = place.has_filename() ? place : place.parent_path();
  const std::string name = target.filename().string();
  Leftovers all = clear_leftovers(target.parent_path().string(), name);
  const Leftovers inside = clear_leftovers(target.string(), name);
  all.cleared += inside.cleared;
  all.kept.insert(all.kept.end(), inside.kept.begin(), inside.kept.end());
  if (all.cleared == 0 || !remark) return;
  remark(fmt::format(
      "cleared what {} that did not end left beside {}",
      all.cleared == 1 ? "an earlier command" : fmt::format("{} earlier commands", all.cleared), path));
  for (const std::string& kept : all.kept)
    remark(fmt::format("{} was in it, and is not Plumb's: it is kept", kept));
}

}  // namespace plumb
