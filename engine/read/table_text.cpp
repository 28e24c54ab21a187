#include "engine/read/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "engine/base/csv.h"
#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/read/table_number.h"

namespace plumb {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw InputError(one_line(name + ": " + what));
}

void append_utf8(std::string& text, char32_t c) {
  if (c < 0x80) {
    text += static_cast<char>(c);
    return;
  }
  const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  constexpr unsigned leads[] = {0, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(leads[more] | c >> (6 * more));
  for (int k = more - 1; k >= 0; --k) text += static_cast<char>(0x80U | (c >> (6 * k) & 0x3FU));
}

/// RFC 2781.
std::string from_utf16(std::string_view bytes, bool big_endian, const std::string& name) {
  if (bytes.size() % 2 != 0) fail(name, "is UTF-16 by its first bytes, and has an odd number of them");
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(bytes[at]),
               second = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<char32_t>(big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 2; at < bytes.size(); at += 2) {
    char32_t c = unit(at);
    if (c >= 0xD800 && c < 0xE000) {
      const char32_t low = c < 0xDC00 && at + 3 < bytes.size() ? unit(at + 2) : 0;
      if (low < 0xDC00 || low >= 0xE000)
        fail(name, fmt::format("is UTF-16 by its first bytes, and damaged at byte {}", at));
      c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
      at += 2;
    }
    append_utf8(text, c);
  }
  return text;
}

std::string decoded(const NamedText& file, std::vector<std::string>& notes) {
  using namespace std::string_view_literals;
  const std::string_view text = file.text;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv))
    fail(file.name, "is UTF-32 by its first bytes, which is not read; save it as UTF-8");
  const bool little = text.starts_with("\xFF\xFE"sv), big = text.starts_with("\xFE\xFF"sv);
  std::string result = little || big ? from_utf16(text, big, file.name) : file.text;
  if (little || big) notes.emplace_back("its text is UTF-16");
  if (result.find('\0') == std::string::npos) return result;
  constexpr std::size_t enough = 64;
  const std::string_view start = text.substr(0, std::min(enough, text.size()));
  if (start.size() >= 4 &&
      static_cast<std::size_t>(std::count(start.begin(), start.end(), '\0')) * 2 + 2 >= start.size())
    fail(file.name,
         "looks like UTF-16 without the mark at its start that tells the order of bytes; save it as UTF-8");
  fail(file.name, "is neither HDF5 nor text: it holds a 0 byte");
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

bool is_empty(std::string_view line) {
  return std::all_of(line.begin(), line.end(), is_blank);
}

bool is_comment(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  return line.starts_with('#') || line.starts_with('%') || line.starts_with('!') || line.starts_with("//");
}

/// Nothing but texts in parentheses or brackets, and what separates them.
bool is_row_of_units(std::string_view line) {
  bool any = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (is_blank(c) || c == ',' || c == ';') continue;
    if (c != '(' && c != '[') return false;
    at = line.find(c == '(' ? ')' : ']', at);
    if (at == std::string_view::npos) return false;
    any = true;
  }
  return any;
}

std::vector<std::string_view> words(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> all;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(separators), line.size());
    if (end > 0) all.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return all;
}

bool all_numbers(const std::vector<std::string_view>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
    std::string text(cell);
    text.erase(0, text.find_first_not_of(" \t\""));
    text.erase(text.find_last_not_of(" \t\"") + 1);
    std::replace(text.begin(), text.end(), ',', '.');
    return table_number(text).has_value();
  });
}

/// What separates the columns whose names are in a line; `row`: the first line of numbers.
char separator_of(std::string_view header, std::string_view row) {
  // What is in quotes separates nothing.
  std::size_t commas = 0, semicolons = 0, tabulators = 0;
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    commas += c == ',' ? 1U : 0U;
    semicolons += c == ';' ? 1U : 0U;
    tabulators += c == '\t' ? 1U : 0U;
  }
  if (semicolons > 0 && semicolons >= commas) return ';';
  if (commas > 0 && commas >= tabulators) return ',';
  // Between tabulators names may have blanks, and what stands in columns may have both between them.
  const std::vector<std::string_view> cells = words(row, "\t");
  if (tabulators > 0 && (words(header, "\t").size() == cells.size() || cells.size() == 1) &&
      (all_numbers(cells) || row.empty()))
    return '\t';
  const std::vector<std::string_view> numbers = words(row, " \t");
  if (numbers.size() > 1 && all_numbers(numbers)) return ' ';
  return tabulators > 0 ? '\t' : ',';
}

/// The lines of a text, and where each begins.
class LinesOfText {
 public:
  explicit LinesOfText(std::string_view text) : text_(text) {}

  /// The next one without its end; nothing after the last.
  std::optional<std::string_view> next() {
    if (at_ >= text_.size()) return {};
    begin_ = at_;
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    at_ = end + 1;
    if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++at_;
    ++number_;
    return text_.substr(begin_, end - begin_);
  }
  std::size_t begin() const { return begin_; }
  int number() const { return number_; }  ///< from 1

 private:
  std::string_view text_;
  std::size_t at_ = 0, begin_ = 0;
  int number_ = 0;
};

/// Leaves comments empty, wherever they are, and says how many there were.
void drop_comments(std::string& text, std::vector<std::string>& notes) {
  int dropped = 0;
  std::string kinds;
  LinesOfText lines(text);
  while (const auto line = lines.next()) {
    if (!is_comment(*line)) continue;
    const char first = (*line)[line->find_first_not_of(" \t")];
    if (kinds.find(first) == std::string::npos)
      kinds += (kinds.empty() ? "" : " or ") + std::string(1, first);
    ++dropped;
    std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(lines.begin()), line->size(), ' ');
  }
  if (dropped > 0)
    notes.push_back(fmt::format("{} passed over, which begin{} with {}",
                                dropped == 1 ? "a line" : fmt::format("{} lines", dropped),
                                dropped == 1 ? "s" : "", kinds));
}

}  // namespace

std::string unit_in_brackets(const std::string& cell) {
  const bool round = cell.starts_with('(') && cell.ends_with(')'),
             square = cell.starts_with('[') && cell.ends_with(']');
  if (!round && !square) return "";
  std::string unit = cell.substr(1, cell.size() - 2);
  unit.erase(0, std::min(unit.find_first_not_of(" \t"), unit.size()));
  unit.erase(unit.find_last_not_of(" \t") + 1);
  return unit == "-" ? "" : unit;
}

TableText table_text(const NamedText& file) {
  TableText table;
  table.text = decoded(file, table.notes);
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (table.text.starts_with(byte_order_mark)) table.text.replace(0, byte_order_mark.size(), "");
  drop_comments(table.text, table.notes);

  // The names, and the first row below them; a row of units tells where they are, whatever is before.
  constexpr int far = 200;
  std::string_view first, before, header, row;
  std::size_t header_at = 0, before_at = 0;
  int passed_over = 0;
  LinesOfText lines(table.text);
  while (const auto line = lines.next()) {
    if (is_empty(*line)) continue;
    if (first.empty()) {
      first = *line;
    } else if (row.empty() && header.empty()) {
      row = *line;  // unless the line is of units
    }
    if (!header.empty()) {
      row = *line;
      break;
    }
    if (is_row_of_units(*line) && !before.empty()) {
      header = before;
      header_at = before_at;
      table.has_units = true;
      row = {};
      continue;
    }
    if (lines.number() > far || all_numbers(words(*line, " \t,;"))) break;
    ++passed_over;
    before = *line;
    before_at = lines.begin();
  }
  if (!table.has_units) header = first;
  table.separator = separator_of(header, row);
  if (table.has_units && passed_over > 1) {
    for (std::size_t at = 0; at < header_at; ++at)
      if (table.text[at] != '\n' && table.text[at] != '\r') table.text[at] = ' ';
    table.notes.push_back(
        fmt::format("{} above the names of the columns passed over",
                    passed_over == 2 ? "a line" : fmt::format("{} lines", passed_over - 1)));
  }
  return table;
}

}  // namespace plumb
