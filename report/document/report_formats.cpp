#include "report/document/report_formats.h"

namespace plumb {

ReportContent content_of(const Document& document) {
  return {document.at("title").get<std::string>(), document, true, suites_of(document), to_summary(document)};
}

// results.json first.
#define PLUMB_REPORT_FORMATS(format) format(results_json) format(junit_xml) format(summary_md)

#define PLUMB_DECLARE(name) ReportFormat name##_format();
PLUMB_REPORT_FORMATS(PLUMB_DECLARE)
#undef PLUMB_DECLARE

std::span<const ReportFormat> report_formats() {
#define PLUMB_LIST(name) name##_format(),
  static const std::vector<ReportFormat> all{PLUMB_REPORT_FORMATS(PLUMB_LIST)};
#undef PLUMB_LIST
  return all;
}

std::span<const std::string_view> report_files() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> files;
    for (const ReportFormat& format : report_formats()) files.push_back(format.file);
    return files;
  }();
  return all;
}

void write_formats(const ReportContent& content, OutputFolder& folder) {
  for (const ReportFormat& format : report_formats())
    folder.write(std::string(format.file), format.text(content));
}

}  // namespace plumb
