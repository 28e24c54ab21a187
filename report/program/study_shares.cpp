#include "report/program/study_shares.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "report/document/report_formats.h"
#include "report/program/run_pipeline.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_shares = 1'000'000;

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

}  // namespace

bool computes_a_part(const Options& options) {
  return !options.share.empty() || !options.only.empty();
}

Scope share_asked_for(const Options& options) {
  Scope scope;
  if (options.share.empty()) return scope;
  const char* at = options.share.data();
  const char* end = at + options.share.size();
  const auto read = [&](std::size_t& number) {
    const auto [next, error] = std::from_chars(at, end, number);
    at = next;
    return error == std::errc() && number >= 1 && number <= most_shares;
  };
  if (!read(scope.share) || at == end || *at++ != '/' || !read(scope.shares) || at != end ||
      scope.share > scope.shares)
    throw UsageError(fmt::format("--share {}: a share is K/N with K from 1 to N and N at most {}, as 3/16",
                                 options.share, most_shares));
  return scope;
}

std::string part_suffix(const Options& options) {
  std::string suffix = options.only.empty() ? "" : ".missing";
  if (!options.share.empty()) {
    const Scope scope = share_asked_for(options);
    suffix += fmt::format(".share-{}-of-{}", scope.share, scope.shares);
  }
  return suffix;
}

Scope scope_asked_for(const Options& options, KeptPoints& points) {
  Scope scope = share_asked_for(options);
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
  console.line(fmt::format("{} of {} are computed; to put all together: plumb study {} {} --merge FOLDER…",
                           counted(static_cast<long>(runner.own_points()), "point", "points"),
                           runner.points(), options.input, kind));
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
  console.error(fmt::format("they are listed in {0}: plumb study {1} {2} --only {0} computes them", list,
                            options.input, kind));
  if (options.json)
    write_to_standard_output(
        nlohmann::ordered_json{
            {"kind", kind}, {"points", runner.points()}, {"missing", missing.size()}, {"list", list}}
            .dump() +
        "\n");
  return ExitStatus::invalid_input;
}

}  // namespace plumb
