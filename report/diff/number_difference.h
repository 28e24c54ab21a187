#pragma once

#include <string>

namespace plumb {

/// How the numbers of two CSV files differ.
struct NumberDifference {
  std::string unlike;   ///< why they cannot be compared: other columns, rows or texts; empty: they can
  double greatest = 0;  ///< difference of two numbers over the largest of their column among rows of one text
  std::string where;    ///< of it: "line 12, y: 0.3 and 0.4"
  long numbers = 0;     ///< pairs of numbers that were compared
  long differing = 0;   ///< of them, those that are not the same
};

/// Compares cell by cell, row by row in their order. Cells that are no numbers, headers among them, must be
/// the same, and tell rows of one kind (of one series, say) from those of another; numbers that are not
/// finite must be the same as well: one that is not beside any other differs without bound. Throws InputError
/// for what is no CSV, and Interrupted.
NumberDifference number_difference(const std::string& a, const std::string& name_a, const std::string& b,
                                   const std::string& name_b);

}  // namespace plumb
