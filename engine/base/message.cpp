#include "engine/base/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <system_error>
#include <typeinfo>

#include "engine/base/errors.h"

namespace plumb {
namespace {

constexpr std::size_t longest_message = 400;
constexpr std::size_t longest_value = 40;
constexpr std::string_view left_out = " … ";

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

struct Character {
  std::size_t length = 1;  ///< bytes
  std::uint32_t code = 0;  ///< where it is valid
  bool valid = false;      ///< well-formed UTF-8
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  if (byte(0) < 0x80) return {1, byte(0), true};
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return {};
  std::uint32_t code = byte(0) & (0x7FU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if (!continues(text[k])) return {};
    code = code << 6U | (byte(k) & 0x3FU);
  }
  constexpr std::uint32_t shortest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < shortest[length] || code > 0x10FFFF || surrogate) return {};
  return {length, code, true};
}

bool is_hidden(std::uint32_t code) {
  constexpr std::pair<std::uint32_t, std::uint32_t> hidden[] = {
      {0x80, 0x9F},     {0xAD, 0xAD},     {0x61C, 0x61C},    {0x180E, 0x180E}, {0x200B, 0x200F},
      {0x2028, 0x202E}, {0x2060, 0x206F}, {0xFDD0, 0xFDEF},  {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF},
      {0xFFF0, 0xFFFB}, {0xE000, 0xF8FF}, {0xE0000, 0xE0FFF}};
  return (code & 0xFFFEU) == 0xFFFEU ||
         std::any_of(std::begin(hidden), std::end(hidden),
                     [&](const auto& range) { return code >= range.first && code <= range.second; });
}

std::string visible(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    if (text[0] == '\n')
      result += "\\n";
    else if (text[0] == '\r')
      result += "\\r";
    else if (text[0] == '\t')
      result += "\\t";
    else if (!character.valid || character.code < 0x20 || character.code == 0x7F)
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else if (is_hidden(character.code))
      result += fmt::format("\\u{:04x}", character.code);
    else
      result += text.substr(0, character.length);
    text.remove_prefix(character.length);
  }
  return result;
}

/// At most that many bytes, and no half character.
std::string_view start_of(std::string_view text, std::size_t length) {
  while (length > 0 && length < text.size() && continues(text[length])) --length;
  return text.substr(0, length);
}

std::string_view end_of(std::string_view text, std::size_t length) {
  std::size_t from = text.size() - std::min(length, text.size());
  while (from < text.size() && continues(text[from])) ++from;
  return text.substr(from);
}

}  // namespace

std::string one_line(const std::string& text) {
  constexpr std::size_t head = longest_message * 3 / 5, tail = longest_message - head - left_out.size();
  std::string_view looked_at = text;
  std::string cut;
  // What goes from the middle need not be looked at.
  if (text.size() > 4 * longest_message) {
    cut.append(start_of(text, longest_message)).append(left_out).append(end_of(text, longest_message));
    looked_at = cut;
  }
  const std::string shown = visible(looked_at);
  if (shown.size() <= longest_message) return shown;
  return std::string(start_of(shown, head)).append(left_out).append(end_of(shown, tail));
}

std::string short_value(std::string_view text) {
  const std::string shown = visible(start_of(text, 4 * longest_value));
  std::size_t length = 0;
  for (std::size_t characters = 0; characters < longest_value && length < shown.size(); ++characters)
    length += first_character(std::string_view(shown).substr(length)).length;
  if (length >= shown.size() && text.size() <= 4 * longest_value) return shown;
  return shown.substr(0, length) + "…";
}

std::string reason(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "there is not enough memory for it";
  if (const auto* system = dynamic_cast<const std::system_error*>(&error)) return system->code().message();
  const std::type_info& type = typeid(error);
  for (const std::type_info* own : {&typeid(std::runtime_error), &typeid(InputError), &typeid(UsageError),
                                    &typeid(OutputError), &typeid(Interrupted)})
    if (type == *own) return one_line(error.what());
  if (dynamic_cast<const std::length_error*>(&error) != nullptr) return "something in it is too long";
  return "something in it is not what it must be";
}

}  // namespace plumb
