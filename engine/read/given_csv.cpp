#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "engine/base/csv.h"
#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/read/given_table.h"
#include "engine/read/table_number.h"
#include "engine/read/table_text.h"

namespace plumb {
namespace {

[[noreturn]] void fail(const std::string& place, const std::string& what) {
  throw InputError(one_line(place + ": " + what));
}

class CsvTable final : public GivenTable {
 public:
  explicit CsvTable(const NamedText& file) : GivenTable(file.name) {
    TableText table = table_text(file);
    notes_ = std::move(table.notes);
    separator_ = table.separator;
    lines_ = parse_csv(table.text, name_, separator_);
    if (lines_.empty()) fail(name_, "has no header: the first line must name the columns");
    if (separator_ == ' ') join_units(lines_.front());
    if (lines_.size() > 1) check_for_numbers();
    read_header();
    if (table.has_units) read_units();
    drop_repeated_headers();
    check_rows();
    static constexpr std::pair<char, const char*> names[] = {
        {',', "commas"}, {';', "semicolons"}, {'\t', "tabulators"}, {' ', "blanks"}};
    std::string columns = "columns are separated by ";
    for (const auto& [sign, name] : names)
      if (sign == separator_) columns += name;
    if (separator_ != ',') notes_.push_back("its " + columns);
    taken_for_ = "a table whose " + columns + (table.has_units ? ", with a row of units" : "");
    find_decimal_sign();
    find_fortran_exponents();
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

  /// Between blanks a unit stands alone: it belongs to the name before it.
  static void join_units(CsvLine& header) {
    for (std::size_t k = 1; k < header.cells.size();) {
      const std::string& text = header.cells[k].text;
      if (text.starts_with('[') && text.ends_with(']')) {
        header.cells[k - 1].text += " " + text;
        header.cells.erase(header.cells.begin() + static_cast<std::ptrdiff_t>(k));
      } else {
        ++k;
      }
    }
  }

  void read_units() {
    const CsvLine& line = lines_[1];
    if (line.cells.size() < columns_.size())
      fail(place_of(line, line.cells.back()),
           fmt::format("the row of units has {} cells, that of the names {}", line.cells.size(),
                       columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (columns_[k].unit.empty()) columns_[k].unit = unit_in_brackets(line.cells[k].text);
    units_line_ = line;
    lines_.erase(lines_.begin() + 1);
  }

  /// A run that was stopped and went on has its header once more in the middle.
  void drop_repeated_headers() {
    const auto same = [](const CsvLine& a, const CsvLine& b) {
      return std::equal(a.cells.begin(), a.cells.end(), b.cells.begin(), b.cells.end(),
                        [](const CsvCell& x, const CsvCell& y) { return x.text == y.text; });
    };
    std::vector<CsvLine> kept;
    std::vector<int> at;
    for (CsvLine& line : lines_) {
      if (kept.empty() || (!same(line, kept.front()) && !same(line, units_line_))) {
        kept.push_back(std::move(line));
      } else if (!same(line, units_line_)) {
        at.push_back(line.number);
        restarts_.push_back(kept.size() - 1);
      }
    }
    lines_ = std::move(kept);
    if (!at.empty())
      notes_.push_back(
          fmt::format("its header is repeated at line{} {}: what follows is taken for the same run going on",
                      at.size() == 1 ? "" : "s", fmt::join(at, ", ")));
  }

  void check_for_numbers() const {
    const auto& cells = lines_.front().cells;
    if (!std::all_of(cells.begin(), cells.end(),
                     [](const CsvCell& cell) { return table_number(cell.text).has_value(); }))
      return;
    fail(place_of(lines_.front(), cells.front()),
         fmt::format("\"{}\" is a number where the header must be: the first line must name the columns{}",
                     short_value(cells.front().text),
                     notes_.empty() ? "" : " (lines that begin with #, %, ! or // are passed over)"));
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
        if (cell.text.find_first_not_of("+-0123456789.,eEdD") != std::string::npos) continue;
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

  void find_fortran_exponents() {
    for (std::size_t row = 1; row < lines_.size(); ++row)
      for (const CsvCell& cell : lines_[row].cells)
        if (!table_number_is_plain(cell.text) && has_fortran_exponent(cell.text)) {
          notes_.push_back(
              fmt::format("\"{}\" and its like are read with the exponents of Fortran", cell.text));
          return;
        }
  }

  /// Most cells: no letter of Fortran's, and no sign but at the start and after an e.
  static bool table_number_is_plain(std::string_view text) {
    const std::size_t sign = text.find_first_of("+-", 1);
    return text.find_first_of("dDqQ") == std::string_view::npos &&
           (sign == std::string_view::npos || text[sign - 1] == 'e' || text[sign - 1] == 'E');
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
    const std::optional<double> value = table_number(text);
    if (!value)
      refuse_cell(separator_ == ',' && text.find(',') != std::string::npos
                      ? "must be a finite number; decimals with commas need columns separated by semicolons"
                      : "must be a finite number");
    if (!std::isfinite(*value)) refuse_cell("must be a finite number");
    return *value;
  }

  std::vector<CsvLine> lines_;  ///< the header and the rows
  CsvLine units_line_;          ///< between them, where there is one
  char separator_ = ',';
  bool decimal_comma_ = false;
  bool ends_in_separator_ = false;
};

}  // namespace

std::unique_ptr<GivenTable> read_given_csv(const NamedText& file) {
  return std::make_unique<CsvTable>(file);
}

}  // namespace plumb
