#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/run/provenance.h"
#include "report/base/stages.h"
#include "report/document/report_formats.h"
#include "report/page/page_scripts.h"

namespace plumb {

/// What the report of a study says, of whatever kind. A kind says what is its own; the files are written
/// here.
struct StudyReport {
  const LoadedCase& loaded;
  std::string subject;  ///< "speed against accuracy"
  Provenance provenance;
  std::vector<Verdict> verdicts;
  Stages stages;              ///< those before the report itself
  std::string headline = {};  ///< what the study concludes, in one sentence
  std::string details = {};   ///< what else it concludes, in sentences; may be empty
  std::string counts = {};    ///< what that rests on: how many runs, and how many criteria are met
  bool complete = true;       ///< false where nothing could be run at all
  Document results = {};      ///< what results.json has of this kind alone: {"stability": {…}}
  std::vector<JunitSuite> suites = suites_of(verdicts);
  std::string before = {}, after = {};  ///< Markdown around the verdicts of summary.md, of whole lines
};

/// What its files but the page say.
ReportContent content_of(const StudyReport& report);

/// A study as a part of its page.
struct StudySection {
  /// Parts of it with their ids: {"study-time", "Time integration"}.
  std::vector<std::pair<std::string, std::string>> links;
  std::string html;
  std::string verdict_note;  ///< HTML, below the verdicts
  std::string css = {};      ///< beside that of every study
  std::vector<PageScript> scripts = {};
  std::string data = {};  ///< HTML: what they work with
};

/// index.html: one file that opens offline.
std::string to_page(const StudyReport& report, const StudySection& section);

}  // namespace plumb
