#pragma once

#include <string>
#include <vector>

#include "report/document/document.h"
#include "report/document/history.h"
#include "report/document/junit_suites.h"
#include "report/index/beside.h"

namespace plumb {

/// A report among several: where it lies, seen from the index, and what it says.
struct IndexedReport {
  std::string folder;          ///< "pendulum"
  Document document = {};      ///< what an index needs of it; null for a run that left none
  int exit_status = 0;         ///< of its run, or that which its verdicts say
  std::string fault = {};      ///< why there is none, or what went wrong beside; may be empty
  std::string thumbnail = {};  ///< PNG of what it shows; may be empty
};

/// What reports are called by their folders, seen from an index: without the leading "../" that all of them
/// have, so that no two are called alike.
std::vector<std::string> names_of(const std::vector<std::string>& folders);

/// A report without what no index needs, such as its figures and energies: many of them have to be kept. Its
/// `errors` become `comparisons`, as comparisons_of() has them.
IndexedReport indexed(const std::string& folder, const Document& document);

/// Figures of the columns of probes that two or more reports have in one unit, over time, one line a report,
/// and of two reports the second minus the first below; at most `most_shared_figures`. Columns of more than
/// `most_shared_lines` reports are left out: their lines could not be told apart.
std::vector<Figure> shared_figures(const std::vector<IndexedReport>& reports);
inline constexpr std::size_t most_shared_figures = 9, most_shared_lines = 12;

/// The results.json of several reports: `kind` "index", `reports[]` with the verdicts of each, what failed
/// first, whether all criteria are met, all comparisons with their statistics, and of each report what
/// `history` holds of its case. `at_once` is how many ran side by side; 0: not known.
Document index_of(const std::vector<IndexedReport>& reports, const std::vector<Picture>& figures,
                  std::size_t at_once = 0, const History& history = {});

/// index.html of several reports, what failed first. `reports` give their thumbnails. Of two that the index
/// has `beside` one another, `pairs` are their pictures, and the figures are charts.
std::string index_page(const Document& index, const std::vector<Picture>& figures,
                       const std::vector<IndexedReport>& reports, const std::vector<PicturePair>& pairs = {});

/// The test cases of several reports: a suite a report and kind of verdict.
std::vector<JunitSuite> index_suites(const std::vector<IndexedReport>& reports);

/// summary.md of several reports, below 64 KiB.
std::string index_summary(const Document& index);

}  // namespace plumb
