#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/errors.h"
#include "engine/input/file_text.h"
#include "engine/input/place.h"
#include "engine/output/manifest.h"
#include "report/file_difference.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder).generic_string());
  // It says what the other files are.
  names.erase(manifest_name);
  return names;
}

bool is_folder(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw InputError(one_line(path + ": there is no such file or folder"));
  return fs::is_directory(path, error);
}

std::vector<FileDifference> compare_folders(const fs::path& a, const fs::path& b,
                                            const DifferenceOptions& options) {
  std::vector<FileDifference> result;
  const std::set<std::string> first = files_in(a), second = files_in(b);
  std::set<std::string> all = first;
  all.insert(second.begin(), second.end());
  for (const std::string& name : all) {
    if (!second.contains(name))
      result.push_back({name, Sameness::only_first, -1, "only in " + a.string(), {}, {}, {}});
    else if (!first.contains(name))
      result.push_back({name, Sameness::only_second, -1, "only in " + b.string(), {}, {}, {}});
    else
      result.push_back(compare_files(name, read_whole_file((a / name).string()),
                                     read_whole_file((b / name).string()), options));
  }
  return result;
}

}  // namespace

std::vector<FileDifference> compare_paths(const std::string& a, const std::string& b,
                                          const DifferenceOptions& options) {
  const bool folder = is_folder(a);
  if (folder != is_folder(b))
    throw InputError(one_line(fmt::format("{} is a {}, {} is not", a, folder ? "folder" : "file", b)));
  try {
    if (folder) return compare_folders(a, b, options);
  } catch (const fs::filesystem_error& error) {
    throw InputError(one_line(error.what()));
  }
  FileDifference only =
      compare_files(fs::path(b).filename().string(), read_whole_file(a), read_whole_file(b), options);
  if (only.sameness == Sameness::not_compared)
    throw InputError(one_line(fmt::format("{}: only PNG and CSV files and results.json can be compared", b)));
  return {only};
}

}  // namespace plumb
