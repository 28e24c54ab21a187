#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// Text for XML and HTML, as content or in a quoted attribute: & < > " ' become entities, and controls, what
/// is no character, and bytes that are no UTF-8 become the replacement character.
std::string escape_xml(std::string_view text);

/// Text for a paragraph or a cell of a table in Markdown: on one line, with nothing that Markdown or HTML
/// would act on; what is no text is replaced as above. One that would have more than `most` bytes ends in "…"
/// before.
std::string escape_markdown(std::string_view text, std::size_t most = std::string_view::npos);

/// Text as code in Markdown, on one line.
std::string markdown_code(std::string_view text);

/// JSON for within an HTML script element, where no "</script" or "<!--" may be.
std::string escape_json_for_html(const std::string& json);

}  // namespace plumb
