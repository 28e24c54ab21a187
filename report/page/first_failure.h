#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// What is to be seen first of a run that failed or met not all of its criteria, as HTML: what moved since
/// the baseline or, where nothing did, the criterion with the worst miss; by how much and when, with the
/// frame of that time. Empty where nothing failed.
std::string first_failure_html(const Document& document, const Pictures& pictures);

}  // namespace plumb
