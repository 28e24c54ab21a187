#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// A cell of a CSV file and where it begins in its line, counted from 1 in characters.
struct CsvCell {
  std::string text;
  int column = 0;
};

/// A line that has something in it.
struct CsvLine {
  int number = 0;  ///< from 1
  std::vector<CsvCell> cells;
};

/// The lines of a CSV file after RFC 4180: cells between commas, in double quotes where they hold a comma, a
/// quote (doubled) or a line's end. Blanks around a cell are no part of it; empty lines are left out; lines
/// may end in CR LF. A blank as separator stands for any number of blanks and
/// tabulators, and what is in parentheses or brackets is one cell then. Throws InputError with `name`, line
/// and column for a quote that is not closed, a text after one that is, or more than ten million cells.
/// Throws Interrupted.
std::vector<CsvLine> parse_csv(std::string_view text, const std::string& name, char separator = ',');

/// A cell as a CSV file has it: in quotes where it must be.
std::string csv_cell(const std::string& text);

}  // namespace plumb
