#pragma once

#include <optional>
#include <string_view>

namespace plumb {

/// The number that is all of a text, with a decimal point and an optional sign; "nan" and "inf" are numbers.
/// Exponents may be Fortran's: "5d-2", and "1.0-101" where three digits leave no room for a letter. One that
/// is too large, or too small to be told from 0, is infinite.
std::optional<double> table_number(std::string_view text);

/// Whether a number has an exponent as Fortran alone writes it.
bool has_fortran_exponent(std::string_view text);

}  // namespace plumb
