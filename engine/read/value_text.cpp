#include "engine/read/value_text.h"

#include <fmt/format.h>

namespace plumb {
namespace {

using Kind = TomlValue::Kind;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return result + '"';
}

}  // namespace

std::string value_text(const TomlValue& value) {
  if (value.kind == Kind::string) return quoted(value.string);
  if (value.kind == Kind::boolean) return value.boolean ? "true" : "false";
  // What was written may be shortened, or end in a comment.
  const bool whole = value.written.find_first_of("#\xE2") == std::string::npos;
  if (!whole && value.kind == Kind::integer) return fmt::format("{:.0f}", value.number);
  if (!whole && value.kind == Kind::real) return fmt::format("{:#}", value.number);
  if (value.kind != Kind::array && value.kind != Kind::table) return value.written;
  const bool table = value.kind == Kind::table;
  std::string items;
  for (const TomlValue& item : value.items)
    items += fmt::format("{}{}{}", items.empty() ? "" : ", ", table ? quoted(item.key) + " = " : "",
                         value_text(item));
  return table ? fmt::format("{{ {} }}", items) : fmt::format("[{}]", items);
}

}  // namespace plumb
