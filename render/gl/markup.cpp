#include "render/gl/markup.h"

#include <algorithm>

namespace plumb {
namespace {

constexpr std::string_view special = "\\^_{}";
constexpr std::string_view minus = "\u2212";

bool beyond_ascii(char c) {
  return static_cast<unsigned char>(c) >= 0x80;
}

bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80;
}

// Bytes of the script that a `^` or `_` at the front of the text opens, without its braces; empty: none.
std::string_view script_after(std::string_view text) {
  const std::string_view rest = text.substr(1);
  if (rest.starts_with('{')) {
    const std::size_t close = rest.find_first_of("{}", 1);
    return close != rest.npos && rest[close] == '}' ? rest.substr(1, close - 1) : std::string_view();
  }
  if (rest.empty() || !beyond_ascii(rest.front())) return {};
  std::size_t size = 1;
  while (size < rest.size() && continues_character(rest[size])) ++size;
  return rest.substr(0, size);
}

std::string with_minus_signs(std::string_view script) {
  std::string result;
  for (std::size_t i = 0; i < script.size(); ++i) {
    const bool negative =
        script[i] == '-' && i + 1 < script.size() && script[i + 1] >= '0' && script[i + 1] <= '9';
    if (negative)
      result += minus;
    else
      result += script[i];
  }
  return result;
}

}  // namespace

std::vector<TextRun> read_markup(std::string_view text) {
  std::vector<TextRun> runs;
  TextRun plain;
  while (!text.empty()) {
    const char c = text.front();
    if (c == '\\' && text.size() > 1 && special.find(text[1]) != special.npos) {
      plain.text += text[1];
      text.remove_prefix(2);
      continue;
    }
    const std::string_view script = c == '^' || c == '_' ? script_after(text) : std::string_view();
    if (script.empty()) {
      plain.text += c;
      text.remove_prefix(1);
      continue;
    }
    if (!plain.text.empty()) runs.push_back(std::move(plain));
    plain = {};
    runs.push_back({with_minus_signs(script), c == '^' ? Script::above : Script::below});
    text.remove_prefix(1 + script.size() + (text[1] == '{' ? 2 : 0));
  }
  if (!plain.text.empty()) runs.push_back(std::move(plain));
  return runs;
}

std::string literal(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != special.npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace plumb
