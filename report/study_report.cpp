#include "report/study_report.h"

#include "engine/output/file_writing.h"
#include "report/study_page.h"

namespace plumb {

std::string write_study_report(const StudyResults& results, const std::vector<Picture>& pictures,
                               OutputFolder& folder) {
  write_file(folder.file("index.html"), to_study_page(results, pictures));
  std::string json = to_json(results);
  write_file(folder.file("results.json"), json);
  write_file(folder.file("junit.xml"), to_junit(results));
  write_file(folder.file("summary.md"), to_summary(results));
  return json;
}

}  // namespace plumb
