#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/run/output_folder.h"
#include "report/document/document.h"
#include "report/document/junit_suites.h"

namespace plumb {

/// What a report says, be it of a run, of a study or of several reports, as its formats take it.
struct ReportContent {
  std::string title;
  Document document;               ///< results.json
  bool has_sum = true;             ///< whether results.json ends with its check sum
  std::vector<JunitSuite> suites;  ///< all that was judged
  std::string summary;             ///< Markdown, below 64 KiB
};

/// That of a run.
ReportContent content_of(const Document& document);

/// A file that every report has beside its page.
struct ReportFormat {
  std::string_view file;  ///< "junit.xml"
  std::string (*text)(const ReportContent& content);
};

/// All of them, results.json first. A new one has a file of its own, and its line in report_formats.cpp.
std::span<const ReportFormat> report_formats();
/// Their files.
std::span<const std::string_view> report_files();

/// Writes a file of each. Throws OutputError.
void write_formats(const ReportContent& content, OutputFolder& folder);

}  // namespace plumb
