#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/place.h"
#include "engine/case/case_source.h"

namespace plumb {

/// A value of a TOML text, with where it stands.
struct TomlValue {
  enum class Kind { table, array, string, integer, real, boolean, date };

  Kind kind = Kind::table;
  Place place;
  std::string key;  ///< in a table: the value's key
  Place key_place;  ///< in a table: where the key stands
  std::string
      written;  ///< as it stands in the text: one line, shortened where long; empty for [table] and [[table]]
  int text_column = 0;  ///< of the first character of a string that has no escapes, otherwise 0

  std::vector<TomlValue> items;  ///< of an array or a table, in the order of the text
  std::string string;
  double number = 0;  ///< of an integer or real
  bool boolean = false;

  /// The value of that key in a table, or nullptr.
  const TomlValue* find(std::string_view wanted) const;
  TomlValue* find(std::string_view wanted);
};

/// "a table", "a list", "a string", "a whole number", "a number", "a boolean", "a date or time".
std::string_view words(TomlValue::Kind kind);

/// Reads a TOML text into a table. Throws InputError where it is not valid TOML.
TomlValue parse_toml(const NamedText& text);

}  // namespace plumb
