#include "report/program/from_document.h"

#include <filesystem>

#include "engine/errors.h"
#include "engine/input/parse_json.h"
#include "engine/output/file_writing.h"
#include "report/page.h"
#include "report/program/work.h"

namespace plumb {

namespace fs = std::filesystem;

ExitStatus report_from_document(const Options& options, Talk& talk) {
  const std::string source = fs::absolute(options.from).parent_path().string();
  const fs::path folder = options.output.empty() ? source : options.output;
  try {
    const Document document = read_document(options.from);
    const std::string page = to_page(document, pictures_of(document, source));
    const std::string junit = to_junit(document), summary = to_summary(document);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw OutputError(folder.string() + ": " + error.message());
    write_file((folder / "junit.xml").string(), junit);
    write_file((folder / "summary.md").string(), summary);
    write_file((folder / "index.html").string(), page);
    say_report(document, folder.string(), options, talk);
    return status_of(document);
  } catch (const Document::exception&) {
    refuse_unusable(options.from);
  }
}

}  // namespace plumb
