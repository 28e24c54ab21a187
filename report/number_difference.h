#pragma once

#include <string>

namespace plumb {

/// How the numbers of two CSV files differ.
struct NumberDifference {
  std::string unlike;   ///< why they cannot be compared: other columns, rows or texts; empty: they can
  double greatest = 0;  ///< difference of two numbers over the largest of their column among rows of one text
  std::string where;    ///< of it: "line 12, y: 0.3 and 0.4"
};

/// Compares cell by cell. Cells that are no numbers must be the same, and tell rows of one kind (of one
/// series, say) from those of another; numbers that are not finite must be the same as well. Throws
/// InputError for what is no CSV.
NumberDifference number_difference(const std::string& a, const std::string& name_a, const std::string& b,
                                   const std::string& name_b);

}  // namespace plumb
