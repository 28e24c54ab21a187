#include "engine/base/csv.h"
#include "engine/read/given_table.h"
#include "tests/fuzz/small_files.h"

namespace plumb::fuzz {
namespace {

/// Cells written and read again are the same.
void promise_round_trip(const std::vector<CsvLine>& lines) {
  std::string text;
  for (const CsvLine& line : lines)
    for (std::size_t k = 0; k < line.cells.size(); ++k)
      text += csv_cell(line.cells[k].text) + (k + 1 == line.cells.size() ? "\n" : ",");
  const std::vector<CsvLine> again = parse_csv(text, "again.csv");
  promise(again.size() == lines.size(), "lines are lost as they are written");
  for (std::size_t k = 0; k < lines.size(); ++k) {
    promise(again[k].cells.size() == lines[k].cells.size(), "cells are lost as they are written");
    for (std::size_t c = 0; c < lines[k].cells.size(); ++c)
      promise(again[k].cells[c].text == lines[k].cells[c].text, "a cell changes as it is written");
  }
}

bool feed(std::string_view input) {
  reads<InputError>([&] {
    const std::vector<CsvLine> lines = parse_csv(input, "any.csv");
    // A byte order mark in front of the first cell would be taken for that of the file.
    if (!lines.empty() && !lines.front().cells.front().text.starts_with("\xEF\xBB\xBF"))
      promise_round_trip(lines);
  });
  return reads<InputError>([&] {
    const auto table = read_given_csv({"run.csv", std::string(input)});
    promise(!table->columns().empty(), "a table without columns");
    std::size_t rows = 0;
    for (int column = 0; column < std::ssize(table->columns()); ++column) {
      const std::vector<double> values = table->values(column);
      promise(!values.empty() && (column == 0 || values.size() == rows), "columns of unlike length");
      rows = values.size();
      promise_finite(values, "a number of a column");
      promise(!table->place(column, rows - 1).empty(), "a number without a place");
      promise(table->find(table->columns()[static_cast<std::size_t>(column)].name) == column,
              "a column that is not found");
    }
  });
}

std::vector<std::string> seeds() {
  return {small_source().given_runs.front().text, "# by hand\n\nt;\"x tip [mm]\";y\n0;1,5;2\n1;2,5;-3e-1\n",
          "t\tx\n0\t+1\n0.5\t1e-300\n", "\xEF\xBB\xBFt [s],\"a \"\"b\"\"\", c ,\r\n1,2,3,\r\n4,5,6,\r\n"};
}

}  // namespace

const Target csv_target{"csv", feed, seeds};

}  // namespace plumb::fuzz
