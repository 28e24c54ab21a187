#include "report/document/report_formats.h"

namespace plumb {

ReportContent content_of(const Document& document) {
  return {document.at("title").get<std::string>(), document, true, suites_of(document), to_summary(document)};
}

std::span<const ReportFormat> report_formats() {
  static constexpr ReportFormat all[] = {
      {"results.json",
       [](const ReportContent& content) { return to_json(content.document, content.has_sum); }},
      {"junit.xml", [](const ReportContent& content) { return junit_xml(content.title, content.suites); }},
      {"summary.md", [](const ReportContent& content) { return content.summary; }},
  };
  return all;
}

void write_formats(const ReportContent& content, OutputFolder& folder) {
  for (const ReportFormat& format : report_formats())
    folder.write(std::string(format.file), format.text(content));
}

}  // namespace plumb
