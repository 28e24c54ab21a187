#pragma once

#include <string>
#include <vector>

#include "report/page/page_section.h"

namespace plumb {

/// Script elements, for the end of a body.
std::string script_elements(const std::vector<PageScript>& scripts);

/// JSON for scripts, which find it by its id.
std::string data_element(const std::string& id, const std::string& json);

/// The directive that lets just those scripts run: "script-src 'sha256-…' …".
std::string script_policy(const std::vector<PageScript>& scripts);

/// Those of the page of a run with such sections, in the order in which they need each other.
std::vector<PageScript> page_scripts(const std::vector<PageSection>& sections);

/// The data that they work with, as elements.
std::string page_data(const Document& document, const std::vector<PageSection>& sections);

}  // namespace plumb
