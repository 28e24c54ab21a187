#include "report/program/rebuild_report.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/parse_json.h"
#include "engine/run/output_folder.h"
#include "report/document/report_formats.h"
#include "report/page/page.h"
#include "report/program/printed_page.h"
#include "report/program/run_pipeline.h"
#include "report/program/run_sections.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

/// What is written, and what the document says of itself.
struct Remade {
  Document document;
  std::string page;
  std::vector<std::pair<std::string, std::string>> files;  ///< the others: names and texts
  ExitStatus status;
};

Remade remake(const std::string& path, const std::string& folder) {
  try {
    Remade made{read_document(path), {}, {}, ExitStatus::done};
    check_claims(made.document, path);
    made.page = to_page(made.document, pictures_of(made.document, folder), page_sections());
    const ReportContent content = content_of(made.document);
    for (const ReportFormat& format : report_formats().subspan(1))
      made.files.emplace_back(format.file, format.text(content));
    made.status = status_of(made.document);
    return made;
  } catch (...) {
    refuse_unusable(path);
  }
}

}  // namespace

ExitStatus report_from_document(const Options& options, Console& console) {
  std::error_code ignored;
  const bool folder_given = fs::is_directory(options.from, ignored);
  if (folder_given || fs::path(options.from).extension() == ".html")
    throw UsageError(fmt::format("--from {}: is a {}; name the results.json {} it", options.from,
                                 folder_given ? "folder" : "page", folder_given ? "in" : "beside"));
  const std::string source = fs::absolute(options.from).parent_path().string();
  const fs::path folder = options.output.empty() ? source : options.output;
  const Remade made = remake(options.from, source);
  if (!made.document.contains(check_sum_key)) console.remark(remark_without_sum(options.from));
  OutputFolder output(folder.string(),
                      {.content = FolderContent::pages,
                       .formats = report_files(),
                       .sources = {options.from},
                       .adds = true,
                       .beside_others = true,
                       .remark = [&console](const std::string& text) { console.remark(text); }});
  for (const auto& [file, text] : made.files) output.write(file, text);
  output.write("index.html", made.page);
  add_pdf(output, options);
  output.commit();
  say_report(made.document, folder.string(), options, console);
  return made.status;
}

}  // namespace plumb
