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
#include "report/index/study_as_report.h"
#include "report/program/earlier_report.h"
#include "report/program/history_file.h"
#include "report/program/output_use.h"
#include "report/program/printed_page.h"
#include "report/program/run_pipeline.h"
#include "report/program/study_kinds.h"
#include "report/program/work_precision_pipeline.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

/// In pixels: of many, all are to have room on a page.
int thumbnail_width(std::size_t among) {
  return among > 120 ? 104 : 160;
}

/// A picture of a report, or the last frame of an animation; empty where there is none that can be read.
std::string picture_in(const fs::path& folder, const std::string& name) {
  try {
    const fs::path inner = fs::path(name).lexically_normal();
    if (inner.empty() || inner.is_absolute() || *inner.begin() == "..") return "";
    const std::string file = (folder / inner).string();
    return split_apng(read_whole_file(file, InputKind::picture), file).back();
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {
    return "";
  }
}

/// A picture of what a report shows, in small: the end of its animation, else its first figure.
std::string thumbnail_in(const fs::path& folder, const Document& document, int width) {
  try {
    const bool animated = document.at("animation").value("frames", 0) > 0;
    if (!animated && document.at(figures_key).empty()) return "";
    const std::string name =
        animated ? std::string(player_file) : document.at(figures_key)[0].at("file").get<std::string>();
    const std::string picture = picture_in(folder, name);
    return picture.empty() ? "" : encode_png(thumbnail(decode_png(picture, name), width));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {
    // It is there to be found by, no more.
    return "";
  }
}

/// A report with where it lies.
struct FoundReport {
  fs::path folder;
  std::string seen;  ///< from the index
  Document document;
};

/// The report in a folder, be it of a run or of a study.
Document report_at(const fs::path& folder) {
  const std::string file = (folder / "results.json").string();
  if (!is_study(folder.string()) && !study_json_at(folder.string())) return find_document(file);
  try {
    std::vector<std::string> pictures;
    std::error_code ignored;
    for (fs::directory_iterator entry(folder / "figures", ignored), end; !ignored && entry != end;
         entry.increment(ignored))
      if (entry->path().extension() == ".png")
        pictures.push_back("figures/" + entry->path().filename().string());
    std::sort(pictures.begin(), pictures.end());
    const Document study = parse_json<Document>(read_whole_file(file), file);
    if (study.at("schema_version").get<int>() > results_version)
      throw InputError(fmt::format("{}: is of version {}, and this program reads up to {}", file,
                                   study.at("schema_version").get<int>(), results_version));
    Document report = study_as_report(study, pictures);
    check_claims(report, file);
    return report;
  } catch (...) {
    refuse_unusable(file);
  }
}

/// Where what both have cannot be read, it is said among what cannot be compared.
Beside beside_one_another(const FoundReport& first, const FoundReport& second) {
  const std::vector<std::string> names = names_of(std::vector{first.seen, second.seen});
  Beside beside{beside_of(first.document, names[0], second.document, names[1])};
  const auto add = [&](const std::string& name, const std::string& title) {
    PicturePair pair{title, picture_in(first.folder, name), picture_in(second.folder, name)};
    if (!pair.first.empty() && !pair.second.empty())
      beside.pictures.push_back(std::move(pair));
    else
      beside.document["not_compared"].push_back({{"what", name}, {"why", "it cannot be read in both"}});
  };
  const auto animated = [](const FoundReport& report) {
    return report.document.at("animation").value("frames", 0) > 0;
  };
  if (animated(first) && animated(second)) add(player_file, "the end of the run");
  const Document &figures = first.document.at(figures_key), &others = second.document.at(figures_key);
  for (const Document& figure : figures)
    if (std::any_of(others.begin(), others.end(),
                    [&](const Document& other) { return other.at("file") == figure.at("file"); }))
      add(figure.at("file").get<std::string>(), figure.at("title").get<std::string>());
  return beside;
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
                       const Options& options, Console& console, const Beside& beside) {
  DrawingTools tools;
  std::vector<Picture> pictures;
  for (Picture& picture : drawn_figures(shared_figures(reports), tools, "index")) {
    folder.write(picture.file, picture.png);
    pictures.push_back(std::move(picture));
  }
  Document index = index_of(reports, pictures, at_once,
                            options.history.empty() ? History() : read_history(options.history));
  if (!beside.document.is_null()) index["beside"] = beside.document;
  write_formats({"Plumb", index, true, index_suites(reports), index_summary(index)}, folder);
  folder.write("index.html", index_page(index, pictures, reports, beside.pictures));
  add_pdf(folder, options);
  folder.commit();
  console.line(index.at("headline").get<std::string>());
  if (index.contains("beside")) console.line(index["beside"].at("headline").get<std::string>());
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
  std::vector<FoundReport> found;
  FolderUse use = use_of_index(console);
  for (const std::string& path : folders) {
    std::error_code ignored;
    const fs::path own = fs::is_regular_file(path, ignored) ? fs::absolute(path).parent_path()
                         : fs::path(path).has_filename()    ? fs::path(path)
                                                            : fs::path(path).parent_path();
    const fs::path seen =
        fs::absolute(own).lexically_normal().lexically_relative(fs::absolute(folder).lexically_normal());
    const std::string file = (own / "results.json").string();
    const Document document = report_at(own);
    const bool study = document.contains(study_results_key);
    if (study && !options.history.empty())
      throw UsageError(fmt::format("--history is of runs, and {} is a study", path));
    if (!study) check_claims(document, file);
    if (!study && !document.contains(check_sum_key)) console.remark(remark_without_sum(file));
    reports.push_back(report_in(own.string(), seen.generic_string(), document, folders.size()));
    // Of more than two none is compared with another one.
    if (folders.size() == 2) found.push_back({own, seen.generic_string(), document});
    use.reads.push_back((own / "results.json").string());
    if (!options.history.empty()) entries.push_back(history_entry(document));
  }
  OutputFolder index(folder, use);
  if (!options.history.empty()) refuse_to_overwrite("--history", options.history, use.reads, index.path());
  for (const Document& entry : entries) append_history(options.history, entry);
  const Beside beside = found.size() == 2 ? beside_one_another(found[0], found[1]) : Beside();
  return write_index(std::move(reports), 0, index, options, console, beside);
}

}  // namespace plumb
