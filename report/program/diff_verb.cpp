#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/base/file_writing.h"
#include "engine/base/interrupt.h"
#include "engine/base/message.h"
#include "engine/run/output_folder.h"
#include "report/diff/difference_page.h"
#include "report/program/output_use.h"
#include "report/program/print_json.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// The files of a folder by their names below it. Throws InputError for one that a folder of files with a
/// manifest cannot have.
std::vector<std::string> files_to_take(const fs::path& folder) {
  std::vector<std::string> names;
  const auto refuse = [](const fs::path& path, const std::string& why) {
    throw InputError(one_line(fmt::format("{}: {}, so it cannot be accepted", path.string(), why)));
  };
  if (const FoundManifest found = find_manifest(open_folder(folder.string() + "/.").get());
      !found.fault.empty())
    refuse(folder / manifest_name, found.fault + ", and no other file may have that name");
  try {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      stop_if_interrupted();
      const std::string name = entry.path().lexically_relative(folder).generic_string();
      if ((entry.is_directory() && !entry.is_symlink()) || name == manifest_name) continue;
      if (!entry.is_regular_file()) refuse(entry.path(), "is no file, or a link to none");
      if (!is_name_listed_as_it_is(name)) refuse(entry.path(), "has a name that is no UTF-8");
      names.push_back(name);
    }
  } catch (const fs::filesystem_error& error) {
    throw InputError(one_line(fmt::format("{}: {}", error.path1().string(), reason(error))));
  }
  return names;
}

/// Puts B in the place of A; B stays.
void accept(const fs::path& a, const fs::path& b, Console& console) {
  if (!fs::is_directory(b)) {
    write_file(a.string(), read_whole_file(b.string()));
    return;
  }
  const std::vector<std::string> names = files_to_take(b);
  OutputFolder folder(a.string(), {.content = FolderContent::copies,
                                   .remark = [&console](const std::string& text) { console.remark(text); }});
  for (const std::string& name : names) folder.write(name, read_whole_file((b / name).string()));
  folder.commit();
}

/// All files that a comparison may read.
std::vector<std::string> files_of_both(const std::string& a, const std::string& b) {
  std::vector<std::string> files;
  for (const std::string& path : {a, b}) {
    std::error_code error;
    if (!fs::is_directory(path, error)) files.push_back(path);
    for (fs::recursive_directory_iterator entry(path, error), end; !error && entry != end;
         entry.increment(error))
      files.push_back(entry->path().string());
  }
  return files;
}

nlohmann::ordered_json difference_json(const std::vector<FileDifference>& files, bool accepted) {
  // Where nothing was compared, neither is known.
  const bool agree = compared(files) > 0 && !differs(files);
  nlohmann::ordered_json json{{"different", compared(files) > 0 ? nlohmann::ordered_json(!agree) : nullptr},
                              {"agree", agree},
                              {"compared", compared(files)},
                              {"accepted", accepted},
                              {"files", nlohmann::ordered_json::array()}};
  for (const FileDifference& file : files)
    json["files"].push_back({{"name", file.name},
                             {"result", word(file.sameness)},
                             {"number", file.number},
                             {"in_words", file.in_words}});
  return json;
}

/// Nothing that is compared is written over by the page about it.
void check_page(const Options& options) {
  std::error_code ignored;
  if (options.html.empty() || !fs::exists(options.html, ignored)) return;
  for (const std::string& compared : {options.input, options.other})
    if (const std::string how = overlap(compared, options.html); !how.empty())
      throw UsageError(fmt::format("--html {}: is there, and {}", options.html, how));
}

void say(const std::vector<FileDifference>& files, Console& console) {
  for (const FileDifference& file : files) {
    if (file.sameness == Sameness::identical || file.sameness == Sameness::not_compared) continue;
    const std::string result = fmt::format("{:<17}", word(file.sameness));
    console.line(fmt::format("  {}{}", fails(file.sameness) ? console.bad(result) : result,
                             one_line(file.name + ": " + file.in_words)));
  }
  console.line(headline(files));
}

ExitStatus do_diff(const Options& options, Console& console) {
  DifferenceOptions how{options.channel, options.density, DifferenceOptions{}.numbers, !options.html.empty()};
  if (options.numbers) how.numbers = *options.numbers;
  const std::string overlapping = overlap(options.input, options.other);
  if (options.accept && !overlapping.empty())
    throw UsageError("--accept would put one in the place of the other: " + overlapping);
  check_page(options);
  std::error_code ignored;
  if (!options.html.empty())
    refuse_to_overwrite("--html", options.html, files_of_both(options.input, options.other));
  const bool first_there = fs::exists(options.input, ignored) || !options.accept;
  std::vector<FileDifference> files;
  if (first_there) files = compare_paths(options.input, options.other, how);
  if (!overlapping.empty()) console.remark(overlapping);

  const bool different = differs(files);
  if (first_there) say(files, console);
  if (!options.html.empty()) {
    write_file(options.html, to_difference_page(options.input, options.other, files));
    console.line("page: " + options.html);
  }
  const bool accepts = options.accept && (different || !first_there);
  if (accepts) {
    accept(options.input, options.other, console);
    console.line(fmt::format("accepted: {} is now what {} is", options.input, options.other));
  } else if (options.accept) {
    clear_leftovers_of(options.input, [&console](const std::string& text) { console.remark(text); });
    console.line("nothing to accept");
  }
  if (options.json) print_json(difference_json(files, accepts));
  return !accepts && (different || compared(files) == 0) ? ExitStatus::criterion_not_met : ExitStatus::done;
}

}  // namespace

Verb diff_verb() {
  return {.name = "diff",
          .summary = "compare two pictures, two files of numbers, or two output folders",
          .act = do_diff,
          .input = "A",
          .compares = true};
}

}  // namespace plumb
