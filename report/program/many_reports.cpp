#include "report/program/many_reports.h"

#include <fmt/format.h>
#include <glob.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "report/document/report_formats.h"
#include "report/index/run_index.h"
#include "report/program/earlier_report.h"
#include "report/program/limits.h"
#include "report/program/output_use.h"
#include "report/program/run_pipeline.h"
#include "report/program/verbs.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

constexpr const char* default_folder = "output";

/// What an index may touch: all that is not of an index stays.
FolderUse use_of_index(Console& console) {
  return {.content = FolderContent::pages,
          .formats = report_files(),
          .beside_others = true,
          .remark = [&console](const std::string& text) { console.remark(text); }};
}

/// Whether an index may have a file or folder of this name.
bool is_of_index(const std::string& name) {
  return name == manifest_name || belongs_to(FolderContent::pages, name, report_files()) ||
         belongs_to(FolderContent::pages, name + "/x.png");
}

/// Draws the figures of an index and writes all of it.
ExitStatus write_index(const std::vector<IndexedReport>& reports, OutputFolder& folder,
                       const Options& options, Console& console) {
  const GlContext context;
  const PngTexts texts = picture_texts(context, "index");
  std::vector<Picture> pictures;
  for (Picture& picture : drawn_figures(shared_figures(reports), context, texts)) {
    folder.write(picture.file, picture.png);
    pictures.push_back(std::move(picture));
  }
  const Document index = index_of(reports, pictures);
  write_formats({"Plumb", index, true, index_suites(reports), index_summary(index)}, folder);
  folder.write("index.html", index_page(index, pictures));
  folder.commit();
  console.line(index.at("headline").get<std::string>());
  console.line("index: " + folder.path() + "/index.html");
  if (options.json) write_to_standard_output(to_json(index));
  ExitStatus worst = ExitStatus::done;
  for (const IndexedReport& report : reports)
    worst =
        std::max(worst, report.document.is_null() ? ExitStatus::solver_failed : status_of(report.document));
  return worst;
}

/// Tells the results.json in a folder from any that takes its place; nothing where there is none.
std::optional<ino_t> file_number(const std::string& folder) {
  struct stat status {};
  if (::stat((fs::path(folder) / "results.json").c_str(), &status) != 0) return {};
  return status.st_ino;
}

/// Options for one of several cases, which says nothing on standard output.
Options for_one(const Options& options, const std::string& input, const std::string& folder) {
  Options one = options;
  one.input = input;
  one.inputs = {input};
  one.output = folder;
  one.json = false;
  return one;
}

}  // namespace

std::vector<std::string> matching_paths(const std::vector<std::string>& arguments) {
  std::vector<std::string> paths;
  for (const std::string& argument : arguments) {
    std::error_code ignored;
    if (argument.find_first_of("*?[") == std::string::npos || fs::exists(argument, ignored)) {
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

ExitStatus run_many(const std::vector<std::string>& cases, const Options& options, Console& console) {
  const std::string folder = options.output.empty() ? default_folder : options.output;
  if (!options.baseline.empty())
    throw UsageError("--baseline is for one case; with several, run each against its own");
  std::map<std::string, std::string> names;
  for (const std::string& path : cases) {
    const std::string name = folder_name_of(path);
    if (is_of_index(name))
      throw UsageError(
          fmt::format("{}: its results would be in {}/{}, and the index over several cases has a "
                      "{} there; rename it, or run it alone",
                      path, folder, name, name));
    const auto [known, first] = names.emplace(name, path);
    if (!first)
      throw UsageError(
          fmt::format("{} and {} would both be written to {}/{}", known->second, path, folder, known->first));
    const LoadedCase loaded = load_case(path, options.overrides);
    Console nothing(true, true);
    check_estimate(loaded.spec, work_of_run(loaded.spec), path, folder, options, nothing);
    const std::string own = (fs::path(folder) / name).string();
    OutputFolder::check(own, folder_for(loaded, for_one(options, path, own), console));
  }
  OutputFolder index(folder, use_of_index(console));
  std::vector<IndexedReport> reports;
  ExitStatus worst = ExitStatus::done;
  for (const std::string& path : cases) {
    const std::string name = folder_name_of(path);
    const std::string own = (fs::path(folder) / name).string();
    const std::optional<ino_t> before = file_number(own);
    worst = std::max(worst, run_one(for_one(options, path, own), console));
    // A start that is not finite leaves no report, and one of an earlier run says nothing of this one.
    const bool made = file_number(own).has_value() && file_number(own) != before;
    reports.push_back({name, made ? find_document(own) : Document()});
  }
  return std::max(worst, write_index(reports, index, options, console));
}

ExitStatus index_many(const std::vector<std::string>& folders, const Options& options, Console& console) {
  const std::string folder = options.output.empty() ? default_folder : options.output;
  std::vector<IndexedReport> reports;
  FolderUse use = use_of_index(console);
  for (const std::string& path : folders) {
    std::error_code ignored;
    const fs::path own =
        fs::is_regular_file(path, ignored) ? fs::absolute(path).parent_path() : fs::path(path);
    const fs::path seen =
        fs::absolute(own).lexically_normal().lexically_relative(fs::absolute(folder).lexically_normal());
    const std::string file = (own / "results.json").string();
    reports.push_back({seen.generic_string(), find_document(file)});
    check_claims(reports.back().document, file);
    if (!reports.back().document.contains(check_sum_key)) console.remark(remark_without_sum(file));
    use.reads.push_back((own / "results.json").string());
  }
  OutputFolder index(folder, use);
  return write_index(reports, index, options, console);
}

}  // namespace plumb
