#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// What changed since the baseline and since the last run, as a part of a page; empty where a document knows
/// of neither.
std::string changes_html(const Document& document);

}  // namespace plumb
