#pragma once

#include <string>
#include <vector>

#include "report/document/changes.h"

namespace plumb {

/// One for each figure that either report has, but for those of what a clock measured. Those of the earlier
/// one are read from `folder`, and one that is not there has moved.
std::vector<PictureMove> picture_moves(const Document& before, const std::string& folder,
                                       const std::vector<Picture>& now);

}  // namespace plumb
