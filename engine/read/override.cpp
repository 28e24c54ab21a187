#include "engine/read/override.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "engine/base/errors.h"

namespace plumb {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::vector<std::string> split(std::string_view key) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    parts.emplace_back(key.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool is_bare_key(std::string_view part) {
  const auto allowed = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '-';
  };
  return !part.empty() && std::all_of(part.begin(), part.end(), allowed);
}

void set_place(TomlValue& value, const Place& place) {
  value.place = place;
  value.key_place = place;
  value.text_column = 0;
  for (TomlValue& item : value.items) set_place(item, place);
}

/// The one value of "v = …", or nothing where the text is not a TOML value.
std::optional<TomlValue> toml_value(const std::string& text) {
  try {
    TomlValue root = parse_toml({"", "v = " + text});
    if (root.items.size() == 1 && root.items[0].key == "v") return std::move(root.items[0]);
  } catch (const InputError&) {
  }
  return {};
}

TomlValue value_of(const std::string& text, const Place& place) {
  std::optional<TomlValue> value = toml_value(text);
  if (!value) {
    std::string quoted = "\"";
    for (char c : text) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
    value = toml_value(quoted + '"');
  }
  if (!value) refuse(place, "", "", "the value must be UTF-8 text without control characters");
  value->written = text;
  set_place(*value, place);
  return std::move(*value);
}

/// The item that a part of a key names, or nullptr where a table has none.
TomlValue* step_into(TomlValue& parent, const std::string& parent_key, const std::string& part,
                     const Place& place) {
  if (parent.kind == TomlValue::Kind::table) return parent.find(part);
  if (parent.kind == TomlValue::Kind::array) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    const bool whole = error == std::errc{} && end == part.data() + part.size();
    if (whole && index < parent.items.size()) return &parent.items[index];
    refuse(place, "", "",
           fmt::format("{} is a list of {}, numbered from 0; \"{}\" is not one of them", parent_key,
                       parent.items.size(), part));
  }
  refuse(place, "", "", fmt::format("{} is not a table: it is {}", parent_key, words(parent.kind)));
}

}  // namespace

void apply_override(TomlValue& root, const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string key(trimmed(std::string_view(text).substr(0, equals)));
  const std::vector<std::string> parts = split(key);
  constexpr std::size_t most_parts = 10;
  if (equals == std::string::npos || parts.size() > most_parts ||
      !std::all_of(parts.begin(), parts.end(), is_bare_key)) {
    throw UsageError(
        one_line(fmt::format("--set {}: must be KEY=VALUE, as in --set cable.elements=8", text)));
  }
  const std::string value_text(trimmed(std::string_view(text).substr(equals + 1)));
  const Place place{fmt::format("--set {}={}", key, value_text), 0, 0};
  TomlValue value = value_of(value_text, place);

  TomlValue* at = &root;
  std::string at_key;
  for (const std::string& part : parts) {
    TomlValue* next = step_into(*at, at_key, part, place);
    if (next == nullptr) {
      TomlValue& added = at->items.emplace_back();
      added.key = part;
      added.place = added.key_place = place;
      next = &added;
    }
    at = next;
    at_key += at_key.empty() ? part : "." + part;
  }
  value.key = std::move(at->key);
  *at = std::move(value);
}

void refuse_key(const CaseSource& source, const std::string& key, std::string_view what) {
  TomlValue root = parse_toml(source.file);
  for (const std::string& text : source.overrides) apply_override(root, text);
  TomlValue* at = &root;
  for (const std::string& part : split(key))
    if (TomlValue* next = step_into(*at, key, part, root.place)) at = next;
  refuse(at->place, key, at->written, std::string(what));
}

}  // namespace plumb
