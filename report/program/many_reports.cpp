#include "report/program/many_reports.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/base/file_writing.h"
#include "engine/base/parse_json.h"
#include "render/image/apng.h"
#include "render/image/thumbnail.h"
#include "report/document/report_formats.h"
#include "report/program/earlier_report.h"
#include "report/program/history_file.h"
#include "report/program/output_use.h"
#include "report/program/run_pipeline.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

/// In pixels: of many, all are to have room on a page.
int thumbnail_width(std::size_t among) {
  return among > 120 ? 104 : 160;
}

/// A picture of what a report shows, in small: the end of its animation, else its first figure.
std::string thumbnail_in(const fs::path& folder, const Document& document, int width) {
  try {
    const bool animated = document.at("animation").value("frames", 0) > 0;
    if (!animated && document.at(figures_key).empty()) return "";
    const std::string name =
        animated ? std::string(player_file) : document.at(figures_key)[0].at("file").get<std::string>();
    const fs::path inner = fs::path(name).lexically_normal();
    if (inner.is_absolute() || *inner.begin() == "..") return "";
    const std::string file = (folder / inner).string();
    const std::string bytes = read_whole_file(file, InputKind::picture);
    return encode_png(thumbnail(decode_png(split_apng(bytes, file).back(), file), width));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {
    // It is there to be found by, no more.
    return "";
  }
}

}  // namespace

FolderUse use_of_index(Console& console) {
  return {.content = FolderContent::pages,
          .formats = report_files(),
          .beside_others = true,
          .remark = [&console](const std::string& text) { console.remark(text); }};
}

bool is_of_index(const std::string& name) {
  return name == manifest_name || belongs_to(FolderContent::pages, name, report_files()) ||
         belongs_to(FolderContent::pages, name + "/x.png");
}

IndexedReport report_in(const std::string& folder, const std::string& seen, const Document& document,
                        std::size_t among) {
  try {
    IndexedReport report = indexed(seen, document);
    report.exit_status = static_cast<int>(status_of(document));
    report.thumbnail = thumbnail_in(folder, document, thumbnail_width(among));
    return report;
  } catch (...) {
    refuse_unusable((fs::path(folder) / "results.json").string());
  }
}

ExitStatus write_index(std::vector<IndexedReport> reports, std::size_t at_once, OutputFolder& folder,
                       const Options& options, Console& console) {
  DrawingTools tools;
  std::vector<Picture> pictures;
  for (Picture& picture : drawn_figures(shared_figures(reports), tools, "index")) {
    folder.write(picture.file, picture.png);
    pictures.push_back(std::move(picture));
  }
  const Document index = index_of(reports, pictures, at_once,
                                  options.history.empty() ? History() : read_history(options.history));
  write_formats({"Plumb", index, true, index_suites(reports), index_summary(index)}, folder);
  folder.write("index.html", index_page(index, pictures, reports));
  folder.commit();
  console.line(index.at("headline").get<std::string>());
  console.line("index: " + folder.path() + "/index.html");
  if (options.json) write_to_standard_output(to_json(index));
  int worst = 0;
  for (const IndexedReport& report : reports) worst = std::max(worst, report.exit_status);
  return static_cast<ExitStatus>(worst);
}

ExitStatus index_many(const std::vector<std::string>& folders, const Options& options, Console& console) {
  const std::string folder = options.output.empty() ? default_index_folder : options.output;
  if (!options.history.empty()) check_history(options.history, console);
  std::vector<IndexedReport> reports;
  std::vector<Document> entries;
  FolderUse use = use_of_index(console);
  for (const std::string& path : folders) {
    std::error_code ignored;
    const fs::path own = fs::is_regular_file(path, ignored) ? fs::absolute(path).parent_path()
                         : fs::path(path).has_filename()    ? fs::path(path)
                                                            : fs::path(path).parent_path();
    const fs::path seen =
        fs::absolute(own).lexically_normal().lexically_relative(fs::absolute(folder).lexically_normal());
    const std::string file = (own / "results.json").string();
    const Document document = find_document(file);
    check_claims(document, file);
    if (!document.contains(check_sum_key)) console.remark(remark_without_sum(file));
    reports.push_back(report_in(own.string(), seen.generic_string(), document, folders.size()));
    use.reads.push_back((own / "results.json").string());
    if (!options.history.empty()) entries.push_back(history_entry(document));
  }
  OutputFolder index(folder, use);
  if (!options.history.empty()) refuse_to_overwrite("--history", options.history, use.reads, index.path());
  for (const Document& entry : entries) append_history(options.history, entry);
  return write_index(std::move(reports), 0, index, options, console);
}

}  // namespace plumb
