#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/errors.h"
#include "engine/input/file_text.h"
#include "engine/message.h"
#include "engine/output/file_writing.h"
#include "engine/output/output_folder.h"
#include "report/difference_page.h"
#include "report/program/output_use.h"
#include "report/program/print_json.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Puts B in the place of A; B stays.
void accept(const fs::path& a, const fs::path& b, Talk& talk) {
  if (!fs::is_directory(b)) {
    write_file(a.string(), read_whole_file(b.string()));
    return;
  }
  OutputFolder folder(a.string(), {.content = FolderContent::copies,
                                   .remark = [&talk](const std::string& text) { talk.remark(text); }});
  try {
    for (const auto& entry : fs::recursive_directory_iterator(b))
      if (entry.is_regular_file() && entry.path() != b / manifest_name)
        folder.write(entry.path().lexically_relative(b).generic_string(),
                     read_whole_file(entry.path().string()));
  } catch (const fs::filesystem_error& error) {
    throw InputError(one_line(fmt::format("{}: {}", error.path1().string(), reason(error))));
  }
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

nlohmann::ordered_json to_json(const std::vector<FileDifference>& files, bool accepted) {
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

void say(const std::vector<FileDifference>& files, Talk& talk) {
  for (const FileDifference& file : files) {
    if (file.sameness == Sameness::identical || file.sameness == Sameness::not_compared) continue;
    const std::string result = fmt::format("{:<17}", word(file.sameness));
    talk.line(fmt::format("  {}{}", fails(file.sameness) ? talk.bad(result) : result,
                          one_line(file.name + ": " + file.in_words)));
  }
  talk.line(headline(files));
}

}  // namespace

ExitStatus diff_verb(const Options& options, Talk& talk) {
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
  if (!overlapping.empty()) talk.remark(overlapping);

  const bool different = differs(files);
  if (first_there) say(files, talk);
  if (!options.html.empty()) {
    write_file(options.html, to_difference_page(options.input, options.other, files));
    talk.line("page: " + options.html);
  }
  const bool accepts = options.accept && (different || !first_there);
  if (accepts) {
    accept(options.input, options.other, talk);
    talk.line(fmt::format("accepted: {} is now what {} is", options.input, options.other));
  } else if (options.accept) {
    talk.line("nothing to accept");
  }
  if (options.json) print_json(to_json(files, accepts));
  return !accepts && (different || compared(files) == 0) ? ExitStatus::criterion_not_met : ExitStatus::done;
}

}  // namespace plumb
