#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/base/interrupt.h"
#include "engine/base/manifest.h"
#include "engine/base/message.h"
#include "engine/base/place.h"
#include "report/diff/file_difference.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw InputError(one_line(fmt::format("{}: {}", path.string(), why)));
}

/// All in a folder that is no folder itself, and whether it is a file.
std::map<std::string, bool> entries_of(const fs::path& folder) {
  std::map<std::string, bool> entries;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    stop_if_interrupted();
    std::error_code unknown;
    if (entry->is_directory(unknown) && !entry->is_symlink(unknown)) continue;
    entries[entry->path().lexically_relative(folder).generic_string()] = entry->is_regular_file(unknown);
  }
  if (error) refuse(folder, "cannot be read: " + error.message());
  // It says what the other files are.
  entries.erase(manifest_name);
  return entries;
}

bool is_folder(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) refuse(path, "there is no such file or folder");
  if (!fs::is_directory(status) && !fs::is_regular_file(status))
    refuse(path, "is neither a file nor a folder");
  return fs::is_directory(status);
}

/// Whatever their size.
bool same_bytes(const fs::path& a, const fs::path& b) {
  std::error_code error_a, error_b;
  if (fs::file_size(a, error_a) != fs::file_size(b, error_b) && !error_a && !error_b) return false;
  std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
  if (!first) refuse(a, "cannot be read");
  if (!second) refuse(b, "cannot be read");
  std::vector<char> one(1U << 20), other(one.size());
  const auto size = static_cast<std::streamsize>(one.size());
  for (;;) {
    stop_if_interrupted();
    first.read(one.data(), size);
    second.read(other.data(), size);
    if (first.bad()) refuse(a, "cannot be read");
    if (second.bad()) refuse(b, "cannot be read");
    if (first.gcount() != second.gcount() ||
        !std::equal(one.begin(), one.begin() + first.gcount(), other.begin()))
      return false;
    if (first.gcount() < size) return true;
  }
}

FileDifference compare_two(const std::string& name, const fs::path& a, const fs::path& b,
                           const DifferenceOptions& options) {
  try {
    const Comparing how = comparing(name);
    if (how == Comparing::bytes || how == Comparing::nothing) return by_bytes(name, same_bytes(a, b));
    return compare_files(name, read_whole_file(a.string()), a.string(), read_whole_file(b.string()),
                         b.string(), options);
  } catch (const InputError& error) {
    return {name, Sameness::unreadable, -1, error.what(), {}, {}, {}};
  }
}

std::vector<FileDifference> compare_folders(const fs::path& a, const fs::path& b,
                                            const DifferenceOptions& options) {
  std::vector<FileDifference> result;
  const std::map<std::string, bool> first = entries_of(a), second = entries_of(b);
  std::map<std::string, bool> all = first;
  all.insert(second.begin(), second.end());
  for (const auto& [name, ignored] : all) {
    stop_if_interrupted();
    if (!second.contains(name))
      result.push_back({name, Sameness::only_first, -1, "only in " + a.string(), {}, {}, {}});
    else if (!first.contains(name))
      result.push_back({name, Sameness::only_second, -1, "only in " + b.string(), {}, {}, {}});
    else if (!first.at(name) || !second.at(name))
      result.push_back({name, Sameness::unreadable, -1, "is no file, or a link to none", {}, {}, {}});
    else
      result.push_back(compare_two(name, a / name, b / name, options));
  }
  return result;
}

/// The path without links, which need not be there.
fs::path without_links(const std::string& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path, error), error).lexically_normal();
  return result.has_filename() ? result : result.parent_path();
}

bool within(const fs::path& inner, const fs::path& outer) {
  const auto [in, out] = std::mismatch(inner.begin(), inner.end(), outer.begin(), outer.end());
  return out == outer.end();
}

}  // namespace

std::vector<FileDifference> compare_paths(const std::string& a, const std::string& b,
                                          const DifferenceOptions& options) {
  const bool folder = is_folder(a);
  if (folder != is_folder(b))
    throw InputError(one_line(fmt::format("{} is a {}, {} is not", a, folder ? "folder" : "file", b)));
  if (folder) return compare_folders(a, b, options);
  const std::string name = fs::path(b).filename().string();
  FileDifference only = compare_two(name, a, b, options);
  if (only.sameness == Sameness::unreadable) throw InputError(one_line(only.in_words));
  return {only};
}

std::string overlap(const std::string& a, const std::string& b) {
  const fs::path first = without_links(a), second = without_links(b);
  std::error_code ignored;
  if (first == second || fs::equivalent(first, second, ignored))
    return one_line(fmt::format("{} and {} are the same", a, b));
  if (within(second, first)) return one_line(fmt::format("{} lies in {}", b, a));
  if (within(first, second)) return one_line(fmt::format("{} lies in {}", a, b));
  return {};
}

}  // namespace plumb
