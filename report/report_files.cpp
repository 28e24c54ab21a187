#include "report/report_files.h"

#include "engine/output/file_writing.h"
#include "report/page.h"

namespace plumb {

void write_report(const Document& document, const Pictures& pictures, const OutputFolder& folder) {
  write_file(folder.file("index.html"), to_page(document, pictures));
  write_file(folder.file("results.json"), to_json(document));
  write_file(folder.file("junit.xml"), to_junit(document));
  write_file(folder.file("summary.md"), to_summary(document));
}

}  // namespace plumb
