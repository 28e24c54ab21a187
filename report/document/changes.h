#pragma once

#include "report/document/document.h"

namespace plumb {

/// What moved from an earlier report of a case to this one, as a list of `what`, `before` and `now` in words:
/// the case's text, method and settings, how the run ended, verdicts, figures of the probes, counts of work,
/// and what it was made with. Times that a clock took are left out.
Document changes_between(const Document& before, const Document& now);

/// The keys in which the `case` of two reports differs, in the same form: all that decides what a run gives.
/// A key that only one of them has differs. Machine, compiler and place of the file are no keys of a case.
Document case_differences(Document before, Document now);

/// The greatest difference of a probe between two reports.
struct ProbeMove {
  std::string column;  ///< "tip.x"
  std::string unit;
  double greatest = 0;  ///< |now − before|, in `unit`; NaN where either is not a number anywhere
  double largest = 0;   ///< greatest |before| of the column, in `unit`
  double time = 0;      ///< s, where the greatest difference is
  std::string unlike;   ///< why they cannot be compared; empty: they can
};

/// What became of a figure since an earlier report.
struct PictureMove {
  std::string file;  ///< "figures/energy.png"
  bool moved = true;
  double density = -1;   ///< greatest share of the pixels of any window that differ; -1: not compared
  std::string in_words;  ///< how far they differ, or why they could not be compared
};

/// One for each column that either report has.
std::vector<ProbeMove> probe_moves(const Document& before, const Document& now);

}  // namespace plumb
