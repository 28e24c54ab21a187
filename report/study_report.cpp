#include "report/study_report.h"

#include "engine/output/file_writing.h"

namespace plumb {

std::string write_study_report(const StudyResults& results, OutputFolder& folder) {
  std::string json = to_json(results);
  write_file(folder.file("results.json"), json);
  write_file(folder.file("junit.xml"), to_junit(results));
  write_file(folder.file("summary.md"), to_summary(results));
  return json;
}

}  // namespace plumb
