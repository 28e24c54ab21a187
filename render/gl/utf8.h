#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// Unicode code points of a UTF-8 text; each byte that is not part of a valid sequence becomes U+FFFD.
std::u32string decode_utf8(std::string_view text);

/// Appends a code point, which must be one, as UTF-8.
void append_utf8(std::string& text, char32_t point);

}  // namespace plumb
