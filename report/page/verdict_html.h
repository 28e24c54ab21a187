#pragma once

#include <string>
#include <vector>

#include "report/verdict/verdict.h"

namespace plumb {

/// Verdicts as a table of a page, those that failed first.
std::string verdict_html(const std::vector<Verdict>& verdicts);

}  // namespace plumb
