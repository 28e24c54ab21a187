#pragma once

#include <string>
#include <vector>

#include "report/verdict/verdict.h"

namespace plumb {

/// The class of a status in style sheets: "passed", "not-run".
std::string class_of(VerdictStatus status);

/// Verdicts as a table of a page, those that failed first.
std::string verdict_html(const std::vector<Verdict>& verdicts);

}  // namespace plumb
