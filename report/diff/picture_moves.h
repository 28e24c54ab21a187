#pragma once

#include <string>
#include <vector>

#include "report/document/document.h"

namespace plumb {

/// What became of a figure since an earlier report.
struct PictureMove {
  std::string file;  ///< "figures/energy.png"
  bool moved = true;
  double density = -1;   ///< greatest share of the pixels of any window that differ; -1: not compared
  std::string in_words;  ///< how far they differ, or why they could not be compared
};

/// One for each figure that either report has, but for those of what a clock measured. Those of the earlier
/// one are read from `folder`, and one that is not there has moved.
std::vector<PictureMove> picture_moves(const Document& before, const std::string& folder,
                                       const std::vector<Picture>& now);

}  // namespace plumb
