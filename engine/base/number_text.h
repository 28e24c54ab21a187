#pragma once

#include <string>

namespace plumb {

/// A number for a message, in as few digits as tell it from every other: "0.02", "inf", "nan".
std::string number_text(double value);

}  // namespace plumb
