#include "engine/read/table_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "engine/base/nearest.h"
#include "engine/base/number_text.h"

namespace plumb {
namespace {

using Kind = TomlValue::Kind;

/// Of one list of numbers or words, and of one list of tables.
constexpr std::size_t most_values = 1000, most_tables = 10'000;

[[noreturn]] void refuse_kind(const TomlValue& value, const std::string& key, std::string_view expected) {
  refuse(value.place, key, value.written, fmt::format("must be {}, found {}", expected, words(value.kind)));
}

/// Runs of white space, line ends among them, as one space each.
std::string joined(const std::string& text) {
  std::string result;
  for (char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!space) result += c;
    if (space && !result.empty() && result.back() != ' ') result += ' ';
  }
  if (result.ends_with(' ')) result.pop_back();
  return result;
}

std::string prose_in(const TomlValue& value, const std::string& key) {
  if (value.kind != Kind::string) refuse_kind(value, key, "a string");
  std::string text = joined(value.string);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::any_of(text.begin(), text.end(), is_control)) {
    refuse(value.place, key, value.written, "must not hold control characters");
  }
  return text;
}

/// "a", "a or b", "a, b or c", in quotes.
std::string either(const std::vector<std::string>& allowed) {
  std::string text;
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    if (i > 0) text += i + 1 == allowed.size() ? " or " : ", ";
    text += fmt::format("\"{}\"", allowed[i]);
  }
  return text;
}

/// The place of a string among the allowed words.
std::size_t choice_in(const TomlValue& value, const std::string& key,
                      const std::vector<std::string>& allowed) {
  if (value.kind != Kind::string) refuse_kind(value, key, either(allowed));
  const auto found = std::find(allowed.begin(), allowed.end(), value.string);
  if (found == allowed.end()) {
    const std::string_view near = nearest(value.string, allowed);
    refuse(
        value.place, key, value.written,
        fmt::format("must be {}{}", either(allowed),
                    near.empty() || allowed.size() == 1 ? "" : fmt::format("; did you mean \"{}\"?", near)));
  }
  return static_cast<std::size_t>(found - allowed.begin());
}

}  // namespace

TableReader::TableReader(const TomlValue& table, std::string key, const Parameters* parameters)
    : table_(&table), place_(table.place), key_(std::move(key)), parameters_(parameters) {
  if (table.kind != Kind::table) refuse_kind(table, key_, "a table");
}

std::string TableReader::full_key(std::string_view key) const {
  return key_.empty() ? std::string(key) : fmt::format("{}.{}", key_, key);
}

const TomlValue* TableReader::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return table_->find(key);
}

bool TableReader::has(std::string_view key) {
  return find(key) != nullptr;
}

bool TableReader::is_text(std::string_view key) {
  const TomlValue* value = find(key);
  return value != nullptr && value->kind == Kind::string;
}

void TableReader::miss(std::string_view key, std::string_view meaning) {
  if (!missing_key_.empty()) return;
  missing_key_ = key;
  missing_what_ = fmt::format("missing; required: {}", meaning);
}

double TableReader::number_in(const TomlValue& value, const std::string& key, const Range& range) const {
  double number = value.number;
  std::string computed;
  if (value.kind == Kind::string && parameters_ != nullptr) {
    number = parameters_->evaluate(value, key);
    computed = number_text(number);
  } else if (value.kind != Kind::integer && value.kind != Kind::real) {
    refuse_kind(value, key, range.allowed());
  }
  if (!range.contains(number)) {
    const bool finite = std::isfinite(number);
    refuse(value.place, key, value.written,
           fmt::format("must be {}{}", finite ? "" : "finite: ", range.allowed()), computed);
  }
  return number;
}

double TableReader::number(std::string_view key, const Range& range) {
  const TomlValue* value = find(key);
  if (value != nullptr) return number_in(*value, full_key(key), range);
  miss(key, range.allowed());
  return 0;
}

double TableReader::number(std::string_view key, const Range& range, double fallback) {
  return optional_number(key, range).value_or(fallback);
}

std::optional<double> TableReader::optional_number(std::string_view key, const Range& range) {
  const TomlValue* value = find(key);
  if (value == nullptr) return {};
  return number_in(*value, full_key(key), range);
}

int TableReader::whole(std::string_view key, int low, int high, int fallback) {
  return static_cast<int>(number(key, Range::whole_between(low, high), fallback));
}

std::optional<std::vector<double>> TableReader::numbers(std::string_view key, std::size_t count,
                                                        const Range& range) {
  const TomlValue* value = find(key);
  if (value == nullptr) return {};
  const std::string expected =
      fmt::format("a list of {} numbers{}", count, range.unit.empty() ? "" : " (" + range.unit + ")");
  if (value->kind != Kind::array) refuse_kind(*value, full_key(key), expected);
  if (value->items.size() != count) {
    refuse(value->place, full_key(key), value->written,
           fmt::format("must be {}, found {} of them", expected, value->items.size()));
  }
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(number_in(value->items[i], fmt::format("{}.{}", full_key(key), i), range));
  }
  return result;
}

const std::vector<TomlValue>* TableReader::find_list(std::string_view key, std::string_view expected) {
  const TomlValue* value = find(key);
  if (value == nullptr) return nullptr;
  if (value->kind != Kind::array) refuse_kind(*value, full_key(key), expected);
  if (value->items.empty())
    refuse(value->place, full_key(key), value->written, fmt::format("must be {}, found none", expected));
  if (value->items.size() > most_values)
    refuse(value->place, full_key(key), value->written,
           fmt::format("must be {} of at most {}, found {}", expected, most_values, value->items.size()));
  return &value->items;
}

std::optional<std::vector<double>> TableReader::numbers(std::string_view key, const Range& range) {
  const std::vector<TomlValue>* items = find_list(key, "a list of numbers");
  if (items == nullptr) return {};
  std::vector<double> result;
  for (std::size_t i = 0; i < items->size(); ++i)
    result.push_back(number_in((*items)[i], fmt::format("{}.{}", full_key(key), i), range));
  return result;
}

std::optional<std::vector<int>> TableReader::wholes(std::string_view key, int low, int high) {
  const std::vector<TomlValue>* items = find_list(key, "a list of whole numbers");
  if (items == nullptr) return {};
  std::vector<int> result;
  for (std::size_t i = 0; i < items->size(); ++i)
    result.push_back(static_cast<int>(
        number_in((*items)[i], fmt::format("{}.{}", full_key(key), i), Range::whole_between(low, high))));
  return result;
}

std::optional<std::vector<std::size_t>> TableReader::choices(std::string_view key,
                                                             const std::vector<std::string>& allowed) {
  const std::vector<TomlValue>* items = find_list(key, "a list of strings");
  if (items == nullptr) return {};
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < items->size(); ++i)
    result.push_back(choice_in((*items)[i], fmt::format("{}.{}", full_key(key), i), allowed));
  return result;
}

Vec3 TableReader::vector(std::string_view key, std::string_view unit) {
  if (!has(key))
    miss(key, fmt::format("a list of 3 numbers{}", unit.empty() ? "" : fmt::format(" ({})", unit)));
  return vector(key, unit, Vec3::Zero());
}

Vec3 TableReader::vector(std::string_view key, std::string_view unit, const Vec3& fallback) {
  const auto given = numbers(key, 3, Range::any(std::string(unit)));
  return given ? Vec3((*given)[0], (*given)[1], (*given)[2]) : fallback;
}

std::string TableReader::text_in(const TomlValue& value, const std::string& key) const {
  const bool blank = prose_in(value, key).empty();
  if (value.string.find_first_of("\r\n") != std::string::npos) {
    refuse(value.place, key, value.written, "must be one line");
  }
  // As it stands, not with its spaces joined: it may be the name of a file.
  return blank ? std::string() : value.string;
}

std::string TableReader::text(std::string_view key, std::string_view meaning) {
  const TomlValue* value = find(key);
  if (value == nullptr) {
    miss(key, meaning);
    return {};
  }
  std::string text = text_in(*value, full_key(key));
  if (text.empty()) refuse_value(key, fmt::format("must not be empty: {}", meaning));
  return text;
}

std::string TableReader::optional_text(std::string_view key, std::string fallback) {
  const TomlValue* value = find(key);
  return value != nullptr ? text_in(*value, full_key(key)) : fallback;
}

std::string TableReader::prose(std::string_view key, std::string_view meaning) {
  const TomlValue* value = find(key);
  if (value == nullptr) {
    miss(key, meaning);
    return {};
  }
  std::string text = prose_in(*value, full_key(key));
  if (text.empty()) refuse_value(key, fmt::format("must not be empty: {}", meaning));
  return text;
}

std::string TableReader::optional_prose(std::string_view key) {
  const TomlValue* value = find(key);
  return value != nullptr ? prose_in(*value, full_key(key)) : std::string();
}

std::vector<std::string> TableReader::proses(std::string_view key) {
  std::vector<std::string> result;
  const TomlValue* value = find(key);
  if (value == nullptr) return result;
  if (value->kind != Kind::array) refuse_kind(*value, full_key(key), "a list of strings");
  for (std::size_t i = 0; i < value->items.size(); ++i) {
    result.push_back(prose_in(value->items[i], fmt::format("{}.{}", full_key(key), i)));
  }
  return result;
}

bool TableReader::flag(std::string_view key, bool fallback) {
  const TomlValue* value = find(key);
  if (value == nullptr) return fallback;
  if (value->kind != Kind::boolean) refuse_kind(*value, full_key(key), "true or false");
  return value->boolean;
}

std::optional<std::size_t> TableReader::choice(std::string_view key, const std::vector<std::string>& allowed,
                                               bool optional) {
  const TomlValue* value = find(key);
  if (value == nullptr) {
    if (!optional) miss(key, either(allowed));
    return {};
  }
  return choice_in(*value, full_key(key), allowed);
}

TableReader TableReader::table(std::string_view key) {
  static const TomlValue empty;
  const TomlValue* value = find(key);
  if (value != nullptr) return {*value, full_key(key), parameters_};
  TableReader reader(empty, full_key(key), parameters_);
  reader.place_ = place_;
  return reader;
}

TableReader TableReader::required_table(std::string_view key, std::string_view meaning) {
  if (!has(key)) miss(key, meaning);
  return table(key);
}

std::vector<TableReader> TableReader::tables(std::string_view key) {
  std::vector<TableReader> result;
  const TomlValue* value = find(key);
  if (value == nullptr) return result;
  if (value->kind != Kind::array)
    refuse_kind(*value, full_key(key), fmt::format("a list of tables [[{}]]", key));
  if (value->items.size() > most_tables)
    refuse(
        value->place, full_key(key), "",
        fmt::format("at most {} tables [[{}]] are allowed, found {}", most_tables, key, value->items.size()));
  for (std::size_t i = 0; i < value->items.size(); ++i) {
    result.emplace_back(value->items[i], fmt::format("{}.{}", full_key(key), i), parameters_);
  }
  return result;
}

const std::vector<TomlValue>& TableReader::list(std::string_view key, std::string_view meaning) {
  static const std::vector<TomlValue> empty;
  const TomlValue* value = find(key);
  if (value == nullptr) {
    miss(key, meaning);
    return empty;
  }
  if (value->kind != Kind::array) refuse_kind(*value, full_key(key), meaning);
  return value->items;
}

void TableReader::finish() {
  for (const TomlValue& item : table_->items) {
    if (std::find(known_.begin(), known_.end(), item.key) != known_.end()) continue;
    const std::string what = item.written.empty() ? "unknown table" : "unknown key";
    refuse(item.key_place, full_key(item.key), item.written, what + suggestion(item.key, known_));
  }
  if (!missing_key_.empty()) refuse(place_, full_key(missing_key_), "", missing_what_);
}

void TableReader::refuse_value(std::string_view key, std::string_view what) const {
  const TomlValue* value = table_->find(key);
  if (value != nullptr) refuse(value->place, full_key(key), value->written, what);
  refuse(place_, full_key(key), "", what);
}

}  // namespace plumb
