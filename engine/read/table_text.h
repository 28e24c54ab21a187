#pragma once

#include <string>
#include <vector>

#include "engine/case/case_source.h"

namespace plumb {

/// The text of a file of columns, made ready to be parsed.
struct TableText {
  /// UTF-8. What is no part of the table, comments and what stands before the names, is left empty in it, so
  /// that all else is at its line.
  std::string text;
  /// ',', ';', a tabulator, or a blank: any number of blanks and tabulators.
  char separator = ',';
  bool has_units = false;          ///< a row of them follows the names
  std::vector<std::string> notes;  ///< how it was read, where that is not plain
};

/// Finds out how a text has its columns: in which encoding (UTF-8, or UTF-16 with a byte order mark), where
/// the names of the columns are (the first line that is neither empty nor a comment, or the one before a row
/// of units in parentheses or brackets), and what separates them. Comments begin with #, %, ! or //. Throws
/// InputError where it is no text.
TableText table_text(const NamedText& file);

/// The unit of a cell that is "(m/s)" or "[m/s]"; empty of "(-)", "()" and of a cell that is none.
std::string unit_in_brackets(const std::string& cell);

}  // namespace plumb
