#include "engine/read/toml_value.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <new>
#include <tuple>
#include <utility>

#include "engine/base/deep_stack.h"
#include "engine/base/errors.h"

namespace plumb {
namespace {

constexpr std::size_t longest_written = 60;
constexpr std::size_t deepest = 100;
constexpr std::ptrdiff_t most_in_a_text = 1'000'000;

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
    if (position.line != line_) {
      line_ = position.line;
      column_ = 1;
      offset_ = starts_[line_ - 1];
    }
    // Values come mostly in the order of the text, and a list before what is in it: going on from the last
    // place, forth or back, keeps a long line from costing its square.
    const auto within = [&] {
      return offset_ < text_.size() && (static_cast<unsigned char>(text_[offset_]) & 0xC0) == 0x80;
    };
    for (; column_ < position.column && offset_ < text_.size(); ++column_) do
        ++offset_;
      while (within());
    for (; column_ > position.column && offset_ > 0; --column_) do
        --offset_;
      while (offset_ > 0 && within());
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

  TomlValue convert(const toml::node& node, std::size_t depth = 0) {
    TomlValue value;
    value.place = place(node.source());
    if (depth > deepest)
      refuse(value.place, "", "",
             fmt::format("is more than {} tables or lists deep, which is not allowed", deepest));
    if (const toml::table* table = node.as_table()) {
      value.kind = TomlValue::Kind::table;
      value.items.reserve(table->size());
      for (const auto& [key, child] : *table) {
        value.items.push_back(convert(child, depth + 1));
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
      for (const toml::node& child : *array) value.items.push_back(convert(child, depth + 1));
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

/// What the parser says is wrong. At the first line that says anything, without what it found there: the file
/// may be no TOML at all and was named by mistake.
std::string description(const toml::parse_error& error, std::string_view body) {
  std::string_view what = error.description();
  const std::size_t first = body.find_first_not_of(" \t\r\n");
  const auto before = body.substr(0, std::min(first, body.size()));
  if (error.source().begin.line >
      static_cast<toml::source_index>(std::count(before.begin(), before.end(), '\n')) + 1)
    return std::string(what);
  what = what.substr(0, what.find(", saw "));
  return std::string(what.substr(0, what.find(": '")));
}

/// The stack that the parsed text may need to be taken apart, which the parser does by recursion, as it does
/// when it finds a fault. Each level of tables and lists has a point or a bracket somewhere, whatever strings
/// and comments have of them: too many may be counted, never too few. The points of one key are in one line,
/// and the parser refuses more than 256 values within one another.
std::size_t stack_for(std::string_view body) {
  constexpr std::size_t most_nested = 256 + 2;
  constexpr std::size_t bytes_a_node = 512, nodes_a_level = 2;  // of [[a]], a list and a table
  std::size_t all = 0, in_line = 0, most_in_line = 0;
  for (const char c : body) {
    if (c == '\n') in_line = 0;
    if (c != '.' && c != '[' && c != '{') continue;
    ++all;
    most_in_line = std::max(most_in_line, ++in_line);
  }
  return std::min(all, most_nested * (most_in_line + 1)) * nodes_a_level * bytes_a_node;
}

/// Takes apart what it makes on the stack that it is called on.
TomlValue parsed(const std::string& name, std::string_view body) {
  try {
    const toml::table table = toml::parse(body);
    TomlValue value = Converter(name, body).convert(table);
    value.place = {name, 1, 1};
    return value;
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    refuse({name, static_cast<int>(begin.line), static_cast<int>(begin.column)}, "", "",
           fmt::format("not valid TOML: {}", description(error, body)));
  }
}

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
  const auto count = [&](char c) { return std::count(body.begin(), body.end(), c); };
  if (count(',') + count('=') > most_in_a_text)
    throw InputError(one_line(fmt::format("{}: holds more than {} values", text.name, most_in_a_text)));
  TomlValue value;
  try {
    on_deep_stack(stack_for(body), [&] { value = parsed(text.name, body); });
  } catch (const std::bad_alloc&) {
    throw InputError(one_line(fmt::format("{}: there is not enough memory for it", text.name)));
  }
  return value;
}

}  // namespace plumb
