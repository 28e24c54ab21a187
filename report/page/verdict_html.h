#pragma once

#include <string>
#include <vector>

#include "report/verdict/verdict.h"

namespace plumb {

/// What the style of the pages calls a status of a verdict: "passed", "not-run", "another-model".
std::string class_of_status(std::string status);

/// Verdicts as a table of a page, those that failed first.
std::string verdict_html(const std::vector<Verdict>& verdicts);

}  // namespace plumb
