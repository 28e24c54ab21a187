#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "engine/base/csv.h"
#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/read/given_table.h"

namespace plumb {
namespace {

[[noreturn]] void fail(const std::string& place, const std::string& what) {
  throw InputError(one_line(place + ": " + what));
}

/// The number that is all of a text, with a decimal point and an optional sign; "nan" and "inf" are numbers.
std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // A number too large or too small to be told from infinity or 0 is as good as not finite.
  if (error == std::errc::result_out_of_range && end == text.data() + text.size()) return HUGE_VAL;
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

char separator_of(std::string_view header) {
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
  return tabulators > commas ? '\t' : ',';
}

class CsvTable final : public GivenTable {
 public:
  explicit CsvTable(const NamedText& file) : GivenTable(file.name) {
    if (file.text.find('\0') != std::string::npos) fail(name_, "is neither HDF5 nor text: it holds a 0 byte");
    separator_ = separator_of(header_text(file.text));
    lines_ = parse_csv(file.text, name_, separator_);
    const auto comment = [](const CsvLine& line) { return line.cells.front().text.starts_with('#'); };
    const auto header = std::find_if_not(lines_.begin(), lines_.end(), comment);
    const auto passed_over = header - lines_.begin();
    if (header == lines_.end()) fail(name_, "has no header: the first line must name the columns");
    if (passed_over > 0)
      notes_.push_back(fmt::format("{} before the header passed over, which begin{} with #",
                                   passed_over == 1 ? "a line" : fmt::format("{} lines", passed_over),
                                   passed_over == 1 ? "s" : ""));
    lines_.erase(lines_.begin(), header);
    if (lines_.size() > 1) check_for_numbers();
    read_header();
    check_rows();
    if (separator_ == ';') notes_.emplace_back("its columns are separated by semicolons");
    if (separator_ == '\t') notes_.emplace_back("its columns are separated by tabulators");
    find_decimal_sign();
  }

  std::vector<double> values(int column) const override {
    std::vector<double> result;
    result.reserve(lines_.size() - 1);
    for (std::size_t row = 0; row + 1 < lines_.size(); ++row) result.push_back(number(column, row));
    return result;
  }

  std::string place(int column, std::size_t row) const override {
    const CsvLine& line = lines_[row + 1];
    return place_of(line, line.cells[static_cast<std::size_t>(column)]);
  }

 private:
  std::string place_of(const CsvLine& line, const CsvCell& cell) const {
    return fmt::format("{}:{}:{}", name_, line.number, cell.column);
  }

  /// The first line that is no comment and not empty.
  static std::string_view header_text(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    while (!text.empty()) {
      const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
      const std::string_view line = text.substr(0, end);
      const std::size_t first = line.find_first_not_of(" \t");
      if (first != std::string_view::npos && line[first] != '#') return line;
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return {};
  }

  void check_for_numbers() const {
    const auto& cells = lines_.front().cells;
    if (!std::all_of(cells.begin(), cells.end(),
                     [](const CsvCell& cell) { return parse_number(cell.text).has_value(); }))
      return;
    fail(place_of(lines_.front(), cells.front()),
         fmt::format("\"{}\" is a number where the header must be: the first line must name the columns{}",
                     short_value(cells.front().text),
                     notes_.empty() ? "" : " (lines that begin with # are passed over)"));
  }

  void read_header() {
    std::unordered_map<std::string, std::string> first_of;
    for (const CsvCell& cell : lines_.front().cells) {
      const std::string place = place_of(lines_.front(), cell);
      Column column{cell.text, "", place};
      const std::size_t bracket = cell.text.rfind('[');
      if (bracket != std::string::npos && cell.text.ends_with(']')) {
        column.unit = cell.text.substr(bracket + 1, cell.text.size() - bracket - 2);
        column.name = cell.text.substr(0, cell.text.find_last_not_of(" \t", bracket - 1) + 1);
        if (bracket == 0) column.name.clear();
      }
      if (column.name.empty()) {
        // A separator that ends every line makes a last column without a name, and nothing in it.
        if (&cell == &lines_.front().cells.back() && cell.text.empty() && lines_.front().cells.size() > 1) {
          ends_in_separator_ = true;
          continue;
        }
        fail(place, "a column has no name");
      }
      if (const auto [other, is_new] = first_of.emplace(column.name, place); !is_new)
        fail(place, fmt::format("the column \"{}\" is there twice, first at {}", short_value(column.name),
                                other->second));
      columns_.push_back(std::move(column));
    }
  }

  void check_rows() {
    if (lines_.size() < 2) fail(name_, "has a header and no rows");
    const std::size_t count = columns_.size();
    for (std::size_t row = 1; row < lines_.size(); ++row) {
      CsvLine& line = lines_[row];
      const bool spare =
          line.cells.size() == count + 1 && line.cells.back().text.empty() && ends_in_separator_;
      if (line.cells.size() == count || spare) continue;
      const bool longer = line.cells.size() > count;
      const CsvCell& cell = longer ? line.cells[count] : line.cells.back();
      // 0,5,1,2 is what two numbers with decimal commas look like between commas.
      const char* hint = longer && separator_ == ',' && line.cells.size() >= 2 * count - 1
                             ? "; decimals with commas need columns separated by semicolons"
                             : "";
      fail(place_of(line, cell),
           fmt::format("the row has {} cells, the header has {}{}", line.cells.size(), count, hint));
    }
  }

  /// A comma in a number is its decimal sign where it separates no columns; a file that has points as well
  /// could mean either by thousands.
  void find_decimal_sign() {
    if (separator_ == ',') return;
    const CsvCell *with_comma = nullptr, *with_point = nullptr;
    const CsvLine *comma_line = nullptr, *point_line = nullptr;
    for (std::size_t row = 1; row < lines_.size(); ++row)
      for (const CsvCell& cell : lines_[row].cells) {
        if (cell.text.find_first_not_of("+-0123456789.,eE") != std::string::npos) continue;
        if (!with_comma && cell.text.find(',') != std::string::npos) {
          with_comma = &cell;
          comma_line = &lines_[row];
        }
        if (!with_point && cell.text.find('.') != std::string::npos) {
          with_point = &cell;
          point_line = &lines_[row];
        }
      }
    if (!with_comma) return;
    if (with_point)
      fail(place_of(*comma_line, *with_comma),
           fmt::format(
               "\"{}\" has a comma and \"{}\" at {} a point: it cannot be told which is the decimal sign",
               short_value(with_comma->text), short_value(with_point->text),
               place_of(*point_line, *with_point)));
    decimal_comma_ = true;
    notes_.emplace_back("the commas in its numbers are read as decimal signs");
  }

  double number(int column, std::size_t row) const {
    const CsvCell& cell = lines_[row + 1].cells[static_cast<std::size_t>(column)];
    const auto refuse_cell = [&](const std::string& what) {
      fail(place(column, row),
           fmt::format("{} = \"{}\": {}", short_value(columns_[static_cast<std::size_t>(column)].name),
                       short_value(cell.text), what));
    };
    if (cell.text.empty()) refuse_cell("is empty; must be a finite number");
    std::string text = cell.text;
    if (decimal_comma_ && std::count(text.begin(), text.end(), ',') == 1)
      std::replace(text.begin(), text.end(), ',', '.');
    const std::optional<double> value = parse_number(text);
    if (!value)
      refuse_cell(separator_ == ',' && text.find(',') != std::string::npos
                      ? "must be a finite number; decimals with commas need columns separated by semicolons"
                      : "must be a finite number");
    if (!std::isfinite(*value)) refuse_cell("must be a finite number");
    return *value;
  }

  std::vector<CsvLine> lines_;  ///< the header and the rows
  char separator_ = ',';
  bool decimal_comma_ = false;
  bool ends_in_separator_ = false;
};

}  // namespace

std::unique_ptr<GivenTable> read_given_csv(const NamedText& file) {
  return std::make_unique<CsvTable>(file);
}

}  // namespace plumb
