#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"
#include "engine/case/case_words.h"
#include "engine/case/key.h"
#include "engine/read/parameters.h"
#include "engine/read/toml_value.h"

namespace plumb {

/// Reads typed values from one table. A value of the wrong type or out of range is refused at once, with
/// InputError. A missing one is refused by `finish`, after unknown keys: a mistyped key is both, and its name
/// says more. Until then something empty stands in for it, so that nothing may be made of the values before
/// `finish` has returned.
class TableReader {
 public:
  /// `key` is the table's own in errors: "cable", "probe.0", empty for a whole file. Without `parameters`
  /// (nullptr) numbers cannot be given as expressions. Both arguments must outlive the reader.
  TableReader(const TomlValue& table, std::string key, const Parameters* parameters);

  /// A required number.
  double number(std::string_view key, const Range& range);
  /// A number that may be missing.
  double number(std::string_view key, const Range& range, double fallback);
  std::optional<double> optional_number(std::string_view key, const Range& range);
  /// A whole number that may be missing.
  int whole(std::string_view key, int low, int high, int fallback);

  /// The value of a key of a table, by the type of its field, which holds the default. `required` takes the
  /// place of that of the key.
  template <class T>
  void read(const Key& key, T& field, bool required) {
    if constexpr (std::is_enum_v<T>) {
      field = required ? choice<T>(key.name) : choice<T>(key.name, field);
    } else if constexpr (std::is_same_v<T, bool>) {
      field = flag(key.name, field);
    } else if constexpr (std::is_arithmetic_v<T>) {
      field = static_cast<T>(required ? number(key.name, key.range)
                                      : number(key.name, key.range, static_cast<double>(field)));
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      field = optional_number(key.name, key.range);
    } else if constexpr (std::is_same_v<T, Vec3>) {
      field = required ? vector(key.name, key.range.unit) : vector(key.name, key.range.unit, field);
    } else if constexpr (std::is_same_v<T, std::string>) {
      field = required ? text(key.name, key.meaning) : optional_text(key.name, field);
    } else if constexpr (requires { visit_keys(*field, [](const Key&, auto&) {}); }) {
      if (!has(key.name)) return;
      TableReader inner = table(key.name);
      inner.read(field.emplace());
      inner.finish();
    } else if (const auto given = numbers(key.name, field.size(), key.range)) {
      std::transform(given->begin(), given->end(), field.begin(),
                     [](double value) { return static_cast<typename T::value_type>(value); });
    }
  }
  /// All keys of a table that has a `visit_keys`; `computed`: false for an external run, of which it is not
  /// asked how it is computed.
  template <class Spec>
  void read(Spec& spec, bool computed = true) {
    visit_keys(spec, [&](const Key& key, auto& field) {
      read(key, field, key.required && (computed || !key.of_computation));
    });
  }

  /// A required list of three numbers, and one that may be missing.
  Vec3 vector(std::string_view key, std::string_view unit);
  Vec3 vector(std::string_view key, std::string_view unit, const Vec3& fallback);
  /// A list of `count` numbers, or nothing where it is missing.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count, const Range& range);
  /// A list of any number of numbers, one or more, or nothing where it is missing.
  std::optional<std::vector<double>> numbers(std::string_view key, const Range& range);
  /// A list of any number of whole numbers, one or more, or nothing where it is missing.
  std::optional<std::vector<int>> wholes(std::string_view key, int low, int high);
  /// A list of one or more of the allowed words, as places among them, or nothing where it is missing.
  std::optional<std::vector<std::size_t>> choices(std::string_view key,
                                                  const std::vector<std::string>& allowed);

  /// A string of one line; required, and not empty.
  std::string text(std::string_view key, std::string_view meaning);
  /// A string of one line that may be missing or empty.
  std::string optional_text(std::string_view key, std::string fallback);
  /// A required string that may run over several lines, which are joined.
  std::string prose(std::string_view key, std::string_view meaning);
  std::string optional_prose(std::string_view key);
  /// A list of such strings, or nothing where it is missing.
  std::vector<std::string> proses(std::string_view key);

  bool flag(std::string_view key, bool fallback);

  /// One of an enumeration's words; required without `fallback`.
  template <class E>
  E choice(std::string_view key, std::optional<E> fallback = {}) {
    std::vector<std::string> allowed;
    for (const auto& entry : words_of<E>) allowed.emplace_back(entry.word);
    const std::optional<std::size_t> index = choice(key, allowed, fallback.has_value());
    return index ? words_of<E>[*index].value : fallback.value_or(E{});
  }
  /// The place of a value among the allowed words; nothing where it is missing.
  std::optional<std::size_t> choice(std::string_view key, const std::vector<std::string>& allowed,
                                    bool optional);

  /// A table within this one; an empty one stands in for a missing one.
  TableReader table(std::string_view key);
  TableReader required_table(std::string_view key, std::string_view meaning);
  bool has(std::string_view key);
  /// True for a string, where a key may be a word or something else.
  bool is_text(std::string_view key);
  /// A list of tables; none where it is missing.
  std::vector<TableReader> tables(std::string_view key);
  /// A required list.
  const std::vector<TomlValue>& list(std::string_view key, std::string_view meaning);

  /// The number in a value that stands within this table; `full_key` is the value's own in errors.
  double number_in(const TomlValue& value, const std::string& full_key, const Range& range) const;
  /// The one-line string in a value that stands within this table.
  std::string text_in(const TomlValue& value, const std::string& full_key) const;

  /// Refuses keys that have not been asked for, with the nearest one that has, and then missing ones.
  void finish();

  /// Refuses the value of a key, or the whole table where the value was left to its default.
  [[noreturn]] void refuse_value(std::string_view key, std::string_view what) const;

  /// The key of a value of this table as errors show it: "cable.length".
  std::string full_key(std::string_view key) const;
  const TomlValue& value() const { return *table_; }

 private:
  const TomlValue* find(std::string_view key);
  void miss(std::string_view key, std::string_view meaning);
  /// The values of a list that is not empty, or nullptr where it is missing.
  const std::vector<TomlValue>* find_list(std::string_view key, std::string_view expected);

  const TomlValue* table_;
  Place place_;  ///< of the table, or of the one around it where it is missing
  std::string key_;
  const Parameters* parameters_;
  std::vector<std::string> known_;
  std::string missing_key_;
  std::string missing_what_;
};

}  // namespace plumb
