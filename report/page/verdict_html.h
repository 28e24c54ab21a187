#pragma once

#include <string>
#include <vector>

#include "report/verdict/verdict.h"

namespace plumb {

/// The class of a status in style sheets: "passed", "not-run".
std::string class_of(VerdictStatus status);
/// The same of what a document says in the place of one: "not held against anything".
std::string class_of_status(std::string status);

/// Verdicts as a table of a page, those that failed first.
std::string verdict_html(const std::vector<Verdict>& verdicts);

}  // namespace plumb
