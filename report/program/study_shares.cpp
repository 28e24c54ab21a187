#include "report/program/study_shares.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "report/document/report_formats.h"
#include "report/page/reproduce.h"
#include "report/program/run_pipeline.h"
#include "report/program/share_option.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// The journals of a share: in its folder, and beside one that is not finished.
std::vector<std::string> journals_at(const std::string& path) {
  if (is_file(path)) return {path};
  std::string folder = path;
  while (folder.size() > 1 && folder.ends_with('/')) folder.pop_back();
  std::vector<std::string> files;
  for (const std::string& file : {folder + '/' + points_file_name, folder + unfinished_points})
    if (is_file(file)) files.push_back(file);
  return files;
}

/// The command of the same study, as a shell takes it.
std::string study_command(const Options& options, const std::string& kind) {
  std::string words = fmt::format("plumb study {} {}", shell_word(options.input), kind);
  for (const std::string& setting : options.overrides) words += " --set " + shell_word(setting);
  return words;
}

}  // namespace

bool computes_a_part(const Options& options) {
  return !options.share.empty() || !options.only.empty();
}

std::string part_suffix(const Options& options) {
  return (options.only.empty() ? "" : ".missing") + suffix_of(asked_share(options));
}

Scope scope_asked_for(const Options& options, KeptPoints& points) {
  const Share share = asked_share(options);
  Scope scope{.share = share.number, .shares = share.of};
  if (options.only.empty()) return scope;
  points.journal().merge(options.only, points.identity());
  scope.only = points.journal().missing();
  if (scope.only->empty())
    throw InputError(options.only + ": names no missing point, so there is nothing to compute");
  return scope;
}

std::vector<std::string> journals_read(const Options& options) {
  std::vector<std::string> files;
  for (const std::string& path : options.merge)
    for (const std::string& file : journals_at(path)) files.push_back(file);
  if (!options.only.empty()) files.push_back(options.only);
  return files;
}

void merge_journals(const Options& options, const StudyIdentity& identity, Journal& journal,
                    Console& console) {
  for (const std::string& path : options.merge) {
    const std::vector<std::string> files = journals_at(path);
    if (files.empty())
      throw InputError(fmt::format("{}: there is no journal of a share: neither {}/{} nor {}{}", path, path,
                                   points_file_name, path, unfinished_points));
    for (const std::string& file : files) {
      const std::size_t damaged = journal.damaged();
      journal.merge(file, identity);
      if (journal.damaged() > damaged)
        console.remark(fmt::format(
            "{} has {}; what is in no other journal is missing", file,
            counted(static_cast<long>(journal.damaged() - damaged), "damaged line", "damaged lines")));
    }
  }
}

ExitStatus keep_part(const Runner& runner, const KeptPoints& points, const std::string& kind,
                     OutputFolder& folder, const Options& options, Console& console) {
  points.write(folder);
  folder.commit();
  const std::string file = folder.path() + '/' + points_file_name;
  console.line(fmt::format("{} of {} are computed; to put all together: {} --merge FOLDER…",
                           counted(static_cast<long>(runner.own_points()), "point", "points"),
                           runner.points(), study_command(options, kind)));
  console.line("journal: " + file);
  if (options.json)
    write_to_standard_output(nlohmann::ordered_json{{"kind", kind},
                                                    {"share", options.share},
                                                    {"points", runner.points()},
                                                    {"own_points", runner.own_points()},
                                                    {"journal", file}}
                                 .dump() +
                             "\n");
  return ExitStatus::done;
}

ExitStatus say_missing(const Runner& runner, const StudyIdentity& identity, const std::string& folder,
                       const std::string& kind, const Options& options, Console& console) {
  constexpr std::size_t most_named = 5;
  const std::vector<std::string>& missing = runner.missing();
  const std::string list = folder + ".missing.jsonl";
  write_file(list, runner.missing_text(identity));
  console.error(fmt::format("{} of {} points are missing:", missing.size(), runner.points()));
  for (std::size_t k = 0; k < std::min(most_named, missing.size()); ++k) console.error("  " + missing[k]);
  if (missing.size() > most_named) console.error(fmt::format("  and {} more", missing.size() - most_named));
  console.error(fmt::format("they are listed in {}: {} --only {} computes them", list,
                            study_command(options, kind), shell_word(list)));
  if (options.json)
    write_to_standard_output(
        nlohmann::ordered_json{
            {"kind", kind}, {"points", runner.points()}, {"missing", missing.size()}, {"list", list}}
            .dump() +
        "\n");
  return ExitStatus::invalid_input;
}

}  // namespace plumb
