#include "engine/base/folder_survey.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

namespace plumb {
namespace {

constexpr std::string_view figures = "figures/", frames = "frames/";

/// "frames/0000.png" and the like.
bool is_numbered(std::string_view name, std::string_view folder, std::string_view ending) {
  constexpr std::size_t fewest_digits = 4;
  if (name.size() < folder.size() + ending.size() || !name.starts_with(folder) || !name.ends_with(ending))
    return false;
  const std::string_view number = name.substr(folder.size(), name.size() - folder.size() - ending.size());
  return number.size() >= fewest_digits && number.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_figure(std::string_view name) {
  return name.starts_with(figures) && name.find('/', figures.size()) == std::string_view::npos &&
         (name.ends_with(".png") || name.ends_with(".csv"));
}

template <std::size_t n>
bool is_one_of(std::string_view name, const std::string_view (&names)[n]) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

constexpr std::string_view run_names[] = {"run.h5", "probes.csv", "modes.csv"};
constexpr std::string_view page_names[] = {"index.html", "results.json", "report.pdf"};
constexpr std::string_view animation_names[] = {"animation.png", "player.png"};
constexpr std::string_view other_names[] = {"study.h5",        "study.json",       "choice.json",
                                            "assessment.json", "sensitivity.json", "points.jsonl"};
constexpr std::string_view export_names[] = {"run.vtkhdf", "run.glb", "run.pvd"};

bool holds_below(const ListedFiles& files, const std::string& folder) {
  const auto first = files.lower_bound(folder + "/");
  return first != files.end() && first->first.starts_with(folder + "/");
}

/// Names in an open folder below a root, `prefix` before them, that are not among `files`; folders of files
/// that are `listed`, and figures and frames, are looked into. An empty one of which nothing is listed is
/// named itself.
void find_others(int folder, const std::string& prefix, const ListedFiles& files, const ListedFiles& listed,
                 std::set<std::string>& others) {
  Descriptor copy(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  DIR* list = copy ? ::fdopendir(copy.get()) : nullptr;
  if (list == nullptr) throw std::system_error(errno, std::generic_category());
  copy.release();  // closed with the list
  std::vector<std::string> folders;
  bool empty = true;
  while (const dirent* entry = ::readdir(list)) {
    const std::string last = entry->d_name;
    if (last == "." || last == "..") continue;
    empty = false;
    const std::string name = prefix + last;
    if (files.contains(name)) continue;
    struct stat status {};
    const bool is_folder =
        ::fstatat(folder, last.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISDIR(status.st_mode);
    if (is_folder && (holds_below(listed, name) || belongs_to(FolderContent::results, name + "/0000.png")))
      folders.push_back(last);
    else
      others.insert(name);
  }
  ::closedir(list);
  const std::string name = prefix.substr(0, prefix.empty() ? 0 : prefix.size() - 1);
  if (empty && !prefix.empty() && !holds_below(listed, name) && prefix != figures && prefix != frames)
    others.insert(name);
  for (const std::string& last : folders) {
    const Descriptor below(::openat(folder, last.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!below) throw std::system_error(errno, std::generic_category());
    find_others(below.get(), prefix + last + "/", files, listed, others);
  }
}

}  // namespace

bool belongs_to(FolderContent content, std::string_view name, std::span<const std::string_view> formats) {
  const bool run = is_one_of(name, run_names),
             page = is_one_of(name, page_names) || is_figure(name) ||
                    std::find(formats.begin(), formats.end(), name) != formats.end(),
             picture =
                 is_figure(name) || is_numbered(name, frames, ".png") || is_one_of(name, animation_names),
             exported = is_one_of(name, export_names) || is_numbered(name, "vtp/", ".vtp");
  switch (content) {
    case FolderContent::run:
      return run;
    case FolderContent::pages:
      return page;
    case FolderContent::pictures:
      return run || picture;
    case FolderContent::results:
      return run || page || picture || exported || is_one_of(name, other_names);
    case FolderContent::copies:
      return name != manifest_name;
  }
  return false;
}

FolderSurvey look_into(const std::string& path, FolderContent content,
                       std::span<const std::string_view> formats) {
  FolderSurvey survey{open_folder(path)};
  if (!survey.folder) {
    if (errno != ENOENT) throw std::system_error(errno, std::generic_category());
    return survey;
  }
  survey.manifest = find_manifest(survey.folder.get());
  survey.ours = files_that_are_ours(survey.folder.get(), survey.manifest.manifest);
  if (content != FolderContent::copies)
    std::erase_if(survey.ours,
                  [&](const auto& file) { return !belongs_to(FolderContent::results, file.first, formats); });
  find_others(survey.folder.get(), "", survey.ours, survey.manifest.manifest.all(), survey.others);
  if (survey.manifest.there && survey.manifest.fault.empty()) survey.others.erase(manifest_name);
  return survey;
}

}  // namespace plumb
