#include "engine/input/toml_value.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <tuple>
#include <utility>

namespace plumb {
namespace {

constexpr std::size_t longest_written = 60;
constexpr std::size_t most_key_parts = 100;

/// Finds the bytes of a text from the lines and columns that the parser gives, which count characters.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {
    starts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') starts_.push_back(i + 1);
    }
  }

  std::size_t offset(const toml::source_position& position) {
    if (position.line == 0 || position.line > starts_.size()) return text_.size();
    // Values come mostly in the order of the text: going on from the last one keeps a long line from costing
    // its square.
    if (position.line != line_ || position.column < column_) {
      line_ = position.line;
      column_ = 1;
      offset_ = starts_[line_ - 1];
    }
    for (; column_ < position.column && offset_ < text_.size(); ++column_) {
      ++offset_;
      while (offset_ < text_.size() && (static_cast<unsigned char>(text_[offset_]) & 0xC0) == 0x80) ++offset_;
    }
    return offset_;
  }

  std::string_view slice(const toml::source_region& region) {
    const std::size_t begin = offset(region.begin), end = offset(region.end);
    return begin < end ? text_.substr(begin, end - begin) : std::string_view{};
  }

 private:
  std::string_view text_;
  std::vector<std::size_t> starts_;
  toml::source_index line_ = 0, column_ = 0;
  std::size_t offset_ = 0;
};

/// Where a dotted key of more than `most_key_parts` parts goes on, or npos. The parser makes a table of each
/// part and takes them down by recursion, so that a key of some ten thousand parts would run out of stack.
std::size_t find_endless_key(std::string_view text) {
  std::size_t parts = 0;
  bool in_part = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size() - 1);
    } else if (c == '"' || c == '\'') {
      const std::size_t end = text.find_first_of(c == '"' ? "\"\n" : "'\n", i + 1);
      if (end != std::string_view::npos && text[end] == c) i = end;
      in_part = true;
    } else if (c == '.' && in_part) {
      in_part = false;
      if (++parts > most_key_parts) return i;
    } else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-') {
      in_part = true;
    } else if (c != ' ' && c != '\t') {
      in_part = false;
      parts = 0;
    }
  }
  return std::string_view::npos;
}

std::string shortened(std::string_view text) {
  std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
  if (length > longest_written) {
    length = longest_written;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  }
  std::string result(text.substr(0, length));
  return length < text.size() ? result + "…" : result;
}

class Converter {
 public:
  Converter(std::string_view name, std::string_view text) : name_(name), lines_(text) {}

  TomlValue convert(const toml::node& node) {
    TomlValue value;
    value.place = place(node.source());
    if (const toml::table* table = node.as_table()) {
      value.kind = TomlValue::Kind::table;
      value.items.reserve(table->size());
      for (const auto& [key, child] : *table) {
        value.items.push_back(convert(child));
        value.items.back().key = key.str();
        value.items.back().key_place = place(key.source());
      }
      std::stable_sort(value.items.begin(), value.items.end(), [](const TomlValue& a, const TomlValue& b) {
        return std::tie(a.key_place.line, a.key_place.column) <
               std::tie(b.key_place.line, b.key_place.column);
      });
      return value;
    }
    const std::string_view source = lines_.slice(node.source());
    value.written = shortened(source);
    if (const toml::array* array = node.as_array()) {
      value.kind = TomlValue::Kind::array;
      value.items.reserve(array->size());
      for (const toml::node& child : *array) value.items.push_back(convert(child));
      const bool is_header = array->is_array_of_tables() && source.starts_with("[[");
      if (is_header) value.written.clear();
    } else if (const auto* string = node.as_string()) {
      value.kind = TomlValue::Kind::string;
      value.string = string->get();
      for (std::size_t quotes : {std::size_t{1}, std::size_t{3}}) {
        const bool same = source.size() == value.string.size() + 2 * quotes &&
                          source.substr(quotes, value.string.size()) == value.string;
        if (same) value.text_column = value.place.column + static_cast<int>(quotes);
      }
    } else if (const auto* integer = node.as_integer()) {
      value.kind = TomlValue::Kind::integer;
      value.number = static_cast<double>(integer->get());
    } else if (const auto* real = node.as_floating_point()) {
      value.kind = TomlValue::Kind::real;
      value.number = real->get();
    } else if (const auto* boolean = node.as_boolean()) {
      value.kind = TomlValue::Kind::boolean;
      value.boolean = boolean->get();
    } else {
      value.kind = TomlValue::Kind::date;
    }
    return value;
  }

 private:
  Place place(const toml::source_region& region) const {
    return {name_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
  }

  std::string name_;
  Lines lines_;
};

}  // namespace

const TomlValue* TomlValue::find(std::string_view wanted) const {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const TomlValue& item) { return item.key == wanted; });
  return kind == Kind::table && found != items.end() ? &*found : nullptr;
}

TomlValue* TomlValue::find(std::string_view wanted) {
  return const_cast<TomlValue*>(std::as_const(*this).find(wanted));
}

std::string_view words(TomlValue::Kind kind) {
  switch (kind) {
    case TomlValue::Kind::table:
      return "a table";
    case TomlValue::Kind::array:
      return "a list";
    case TomlValue::Kind::string:
      return "a string";
    case TomlValue::Kind::integer:
      return "a whole number";
    case TomlValue::Kind::real:
      return "a number";
    case TomlValue::Kind::boolean:
      return "a boolean";
    case TomlValue::Kind::date:
      return "a date or time";
  }
  return "";
}

TomlValue parse_toml(const NamedText& text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::string_view body = text.text;
  if (body.starts_with(byte_order_mark)) body.remove_prefix(byte_order_mark.size());
  if (const std::size_t at = find_endless_key(body); at != std::string_view::npos) {
    const auto line = std::count(body.begin(), body.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
    refuse({text.name, static_cast<int>(line), 1}, "", "",
           fmt::format("a key of more than {} parts is not allowed", most_key_parts));
  }
  try {
    const toml::table table = toml::parse(body);
    TomlValue value = Converter(text.name, body).convert(table);
    value.place = {text.name, 1, 1};
    return value;
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    refuse({text.name, static_cast<int>(begin.line), static_cast<int>(begin.column)}, "", "",
           fmt::format("not valid TOML: {}", error.description()));
  }
}

}  // namespace plumb
