#include "report/program/installed_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/base/nearest.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Where the cases lie, relative to the program's own folder: installed (bin beside share), and in a build.
constexpr std::array<const char*, 2> folders{"../share/plumb/cases", "share/plumb/cases"};
constexpr const char* extension = ".toml";

/// Empty where there is none.
fs::path cases_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  for (const char* folder : folders)
    if (const fs::path found = fs::canonical(program.parent_path() / folder, error); !error) return found;
  return {};
}

/// References, which lie in folders of their own, are no cases.
bool is_case(const fs::path& relative) {
  return relative.extension() == extension && relative.parent_path().filename() != "references";
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

std::string case_named(const std::string& name) {
  std::error_code error;
  if (name.empty() || fs::symlink_status(name, error).type() != fs::file_type::not_found) return name;
  if (name.find_first_of("*?[") != std::string::npos || fs::path(name).extension() == extension) return name;
  const std::vector<std::string> names = installed_cases();
  if (std::find(names.begin(), names.end(), name) != names.end())
    return (cases_folder() / (name + extension)).string();
  if (fs::path(name).is_absolute() || names.empty()) return name;
  throw InputError(fmt::format("{}: no such file, and no case of this name came with the program{}",
                               short_value(name), suggestion(name, names)));
}

}  // namespace plumb
