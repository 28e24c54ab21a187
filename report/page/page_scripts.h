#pragma once

#include <string>
#include <vector>

#include "report/page/page_section.h"

namespace plumb {

/// A whole page: one file that opens offline. `css` is beside that of every page, `body` its HTML, `data` the
/// elements that its scripts, and none but these, work with.
std::string html_page(const std::string& title, std::string_view css, const std::string& body,
                      const std::vector<PageScript>& scripts = {}, const std::string& data = "");

/// JSON for scripts, which find it by its id.
std::string data_element(const std::string& id, const std::string& json);

/// Those of the page of a run with such sections, in the order in which they need each other.
std::vector<PageScript> page_scripts(const std::vector<PageSection>& sections);

/// The data that they work with, as elements.
std::string page_data(const Document& document, const std::vector<PageSection>& sections);

}  // namespace plumb
