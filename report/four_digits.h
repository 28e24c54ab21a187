#pragma once

#include <string>

#include "report/document.h"

namespace plumb {

/// A number of a table, "1.234e-05"; "not finite" where it is none.
std::string four_digits(double value);
/// The same of a document, in which null stands for what is not finite.
std::string four_digits(const Document& value);

}  // namespace plumb
