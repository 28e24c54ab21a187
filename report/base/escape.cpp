#include "report/base/escape.h"

#include <algorithm>

#include "render/gl/utf8.h"

namespace plumb {
namespace {

/// What XML 1.0 forbids, HTML calls an error or a reader of plain text would act on: controls and what is no
/// character.
bool is_forbidden(char32_t c) {
  const bool control = (c < 0x20 && c != '\n' && c != '\t' && c != '\r') || (c >= 0x7F && c < 0xA0);
  return control || (c >= 0xFDD0 && c < 0xFDF0) || (c & 0xFFFEU) == 0xFFFE;
}

/// The characters of a text, with the replacement character for those that are forbidden.
std::u32string characters_of(std::string_view text) {
  std::u32string characters = decode_utf8(text);
  std::replace_if(characters.begin(), characters.end(), is_forbidden, U'\uFFFD');
  return characters;
}

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string result;
  for (const char32_t c : characters_of(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        append_utf8(result, c);
    }
  }
  return result;
}

std::string escape_markdown(std::string_view text, std::size_t most) {
  const std::u32string characters = characters_of(text);
  constexpr std::size_t longest_step = 8;  // bytes, of a character and of "…"
  std::string result;
  std::size_t cut = 0;  // a length at which there is room for "…"
  for (std::size_t i = 0; i < characters.size(); ++i) {
    if (result.size() > most) break;
    if (result.size() + longest_step <= most) cut = result.size();
    const char32_t c = characters[i];
    // Addresses become links without any mark.
    const bool of_address = (c == ':' && characters.substr(i + 1, 2) == U"//") ||
                            (c == '.' && i >= 3 && characters.substr(i - 3, 3) == U"www");
    if (c == '\n' || c == '\r' || c == '\t')
      result += ' ';
    else if (c == '<')
      result += "&lt;";
    else if (c == '&')
      result += "&amp;";
    else if (of_address || std::u32string_view(U"\\`*_[]|#~!>").find(c) != std::u32string_view::npos)
      (result += '\\') += static_cast<char>(c);
    else
      append_utf8(result, c);
  }
  if (result.size() > most) {
    result.resize(cut);
    append_utf8(result, U'…');
  }
  return result;
}

std::string markdown_code(std::string_view text) {
  std::string line;
  std::size_t longest = 0, ticks = 0;
  for (const char32_t c : characters_of(text)) {
    ticks = c == '`' ? ticks + 1 : 0;
    longest = std::max(longest, ticks);
    append_utf8(line, c == '\n' || c == '\r' ? U' ' : c);
  }
  const std::string fence(longest + 1, '`');
  return longest > 0 ? fence + " " + line + " " + fence : fence + line + fence;
}

std::string escape_json_for_html(const std::string& json) {
  std::string result;
  for (const char c : json) {
    if (c == '<')
      result += "\\u003c";
    else if (c == '>')
      result += "\\u003e";
    else if (c == '&')
      result += "\\u0026";
    else
      result += c;
  }
  return result;
}

}  // namespace plumb
