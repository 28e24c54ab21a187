#pragma once

#include <string>
#include <vector>

#include "report/diff/file_difference.h"

namespace plumb {

/// A page about a comparison, which opens offline: what differs first, with both pictures and the marks.
std::string to_difference_page(const std::string& a, const std::string& b,
                               const std::vector<FileDifference>& files);

/// "3 of 57 files differ: …", for people.
std::string headline(const std::vector<FileDifference>& files);

}  // namespace plumb
