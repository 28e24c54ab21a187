#include "report/program/from_document.h"

#include <filesystem>

#include "engine/errors.h"
#include "engine/output/output_folder.h"
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
    OutputFolder output(folder.string(), {.content = FolderContent::pages,
                                          .sources = {options.from},
                                          .adds = true,
                                          .beside_others = true,
                                          .remark = [&talk](const std::string& text) { talk.remark(text); }});
    output.write("junit.xml", junit);
    output.write("summary.md", summary);
    output.write("index.html", page);
    output.commit();
    say_report(document, folder.string(), options, talk);
    return status_of(document);
  } catch (const Document::exception& error) {
    throw InputError(options.from + ": damaged: " + error.what());
  }
}

}  // namespace plumb
