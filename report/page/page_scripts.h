#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// The scripts of the page of a run with the data that they work with, for the end of its body.
std::string page_scripts(const Document& document);

/// The directive that lets just those run.
std::string page_script_policy(const Document& document);

}  // namespace plumb
