#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// Text for XML and HTML, as content or in a quoted attribute: & < > " ' become entities, and control
/// characters that XML 1.0 forbids become the replacement character.
std::string escape_xml(std::string_view text);

/// Text for a cell of a Markdown table: on one line, with nothing that Markdown or HTML would act on.
std::string escape_markdown(std::string_view text);

}  // namespace plumb
