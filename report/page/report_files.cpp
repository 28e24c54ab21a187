#include "report/page/report_files.h"

#include "report/page/page.h"

namespace plumb {

void write_report(const Document& document, const Pictures& pictures, OutputFolder& folder) {
  folder.write("index.html", to_page(document, pictures));
  folder.write("results.json", to_json(document));
  folder.write("junit.xml", to_junit(document));
  folder.write("summary.md", to_summary(document));
}

}  // namespace plumb
