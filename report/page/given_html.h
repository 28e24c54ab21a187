#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// What the page says of the external runs of a document: where they are from, how they were read, how far
/// they are from the run that is reported.
std::string given_runs_html(const Document& document);

/// What the page says in the place of a formulation where another program computed the run.
std::string given_formulation_html(const Document& document);

}  // namespace plumb
