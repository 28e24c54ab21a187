#pragma once

#include <string>
#include <vector>

#include "report/page/page_section.h"

namespace plumb {

/// The scripts of the page of a run and of those of its sections, with the data that they work with, for the
/// end of its body.
std::string page_scripts(const Document& document, const std::vector<PageSection>& sections);

/// The directive that lets just those run.
std::string page_script_policy(const std::vector<PageSection>& sections);

}  // namespace plumb
