#include "report/program/installed_cases.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/base/nearest.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Where the cases lie, relative to the program's own folder: installed (bin beside share), and in a build.
constexpr std::array<const char*, 2> case_folders{"../share/plumb/cases", "share/plumb/cases"};
constexpr const char* extension = ".toml";

/// Empty where there is none.
fs::path cases_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  for (const char* folder : case_folders)
    if (const fs::path found = fs::canonical(program.parent_path() / folder, error); !error) return found;
  return {};
}

/// References, which lie in case_folders of their own, are no cases.
bool is_case(const fs::path& relative) {
  return relative.extension() == extension && relative.parent_path().filename() != "references";
}

bool is_pattern(const std::string& text) {
  return text.find_first_of("*?[") != std::string::npos;
}

std::vector<std::string> cases_in(const fs::path& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (std::error_code ignored; at->path().extension() == extension && !at->is_directory(ignored))
      paths.push_back(at->path().string());
  if (error) throw InputError(fmt::format("{}: cannot be read: {}", folder.string(), error.message()));
  if (paths.empty())
    throw InputError(fmt::format("{}: there is no case (*{}) in this folder", folder.string(), extension));
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The folder of cases that a name stands for; empty where it is none.
fs::path folder_named(const std::string& name) {
  std::error_code error;
  if (fs::is_directory(name, error)) return name;
  if (name.empty() || fs::symlink_status(name, error).type() != fs::file_type::not_found) return {};
  const std::vector<std::string> known = installed_folders();
  if (std::find(known.begin(), known.end(), name) != known.end()) return cases_folder() / name;
  const fs::path below = fs::path("cases") / name;
  return fs::path(name).is_relative() && fs::is_directory(below, error) ? below : fs::path();
}

}  // namespace

std::vector<std::string> installed_cases() {
  const fs::path folder = cases_folder();
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (const fs::path relative = at->path().lexically_relative(folder); is_case(relative))
      names.push_back((relative.parent_path() / relative.stem()).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> installed_folders() {
  std::set<std::string> found;
  for (const std::string& name : installed_cases())
    if (const std::string folder = fs::path(name).parent_path().string(); !folder.empty())
      found.insert(folder);
  return {found.begin(), found.end()};
}

std::string case_named(const std::string& name) {
  std::error_code error;
  if (name.empty() || fs::symlink_status(name, error).type() != fs::file_type::not_found) return name;
  if (is_pattern(name) || fs::path(name).extension() == extension) return name;
  std::vector<std::string> names = installed_cases();
  if (std::find(names.begin(), names.end(), name) != names.end())
    return (cases_folder() / (name + extension)).string();
  if (fs::path(name).is_absolute() || names.empty()) return name;
  throw InputError(fmt::format("{}: no such file, and no case of this name came with the program{}",
                               short_value(name), suggestion(name, names)));
}

std::vector<std::string> matching_paths(const std::vector<std::string>& arguments) {
  std::vector<std::string> paths;
  for (const std::string& argument : arguments) {
    std::error_code ignored;
    if (!is_pattern(argument) || fs::exists(argument, ignored)) {
      paths.push_back(argument);
      continue;
    }
    glob_t found{};
    const int result = ::glob(argument.c_str(), 0, nullptr, &found);
    for (std::size_t i = 0; result == 0 && i < found.gl_pathc; ++i) paths.emplace_back(found.gl_pathv[i]);
    ::globfree(&found);
    if (result != 0) throw UsageError(argument + ": nothing matches it");
  }
  return paths;
}

CaseList cases_named(const std::vector<std::string>& arguments) {
  CaseList list;
  for (const std::string& argument : arguments) {
    const fs::path folder = folder_named(argument);
    std::vector<std::string> found;
    if (!folder.empty()) {
      found = cases_in(folder);
      std::error_code ignored;
      if (arguments.size() == 1) list.folder = fs::canonical(folder, ignored).filename().string();
    } else {
      for (const std::string& path : matching_paths({argument})) found.push_back(case_named(path));
    }
    list.paths.insert(list.paths.end(), found.begin(), found.end());
  }
  return list;
}

}  // namespace plumb
