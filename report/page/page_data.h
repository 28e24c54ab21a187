#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// What the scripts of the page of a run work with, as JSON on one line: its figures with their numbers, and
/// how the frames of its animation follow each other. All of it is in the document.
std::string page_data(const Document& document);

}  // namespace plumb
