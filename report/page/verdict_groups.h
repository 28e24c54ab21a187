#pragma once

#include <string>
#include <vector>

#include "report/verdict/verdict.h"

namespace plumb {

/// Verdicts for the page of a run, each kind of evidence apart with what it can tell: kinds and verdicts that
/// failed first, then what was not run. `command` is what makes them again.
std::string verdict_groups(const std::vector<Verdict>& verdicts, const std::string& command);

}  // namespace plumb
