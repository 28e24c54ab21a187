#pragma once

#include <string>
#include <vector>

#include "report/document/document.h"
#include "report/document/junit_suites.h"

namespace plumb {

/// A report among several: where it lies, seen from the index, and what it says.
struct IndexedReport {
  std::string folder;  ///< "pendulum"
  Document document;   ///< null for a run that left none
};

/// Figures of the columns of probes that two or more reports have in one unit, over time, one line a report;
/// at most `most_shared_figures`.
std::vector<Figure> shared_figures(const std::vector<IndexedReport>& reports);
inline constexpr std::size_t most_shared_figures = 9;

/// The results.json of several reports: `kind` "index", `reports[]` with the verdicts of each, and whether
/// all criteria are met.
Document index_of(const std::vector<IndexedReport>& reports, const std::vector<Picture>& figures);

/// index.html of several reports, what failed first.
std::string index_page(const Document& index, const std::vector<Picture>& figures);

/// The test cases of several reports: a suite a report and kind of verdict.
std::vector<JunitSuite> index_suites(const std::vector<IndexedReport>& reports);

/// summary.md of several reports, below 64 KiB.
std::string index_summary(const Document& index);

}  // namespace plumb
