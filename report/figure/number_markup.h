#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// A unit as the labels of figures write it (markup.h): "m/s" is "m s^{-1}", "1/m" is "m^{-1}". Others stay.
std::string unit_markup(std::string_view unit);

/// A number as the labels of figures write it: "3.1·10^{−12}", or "0.031".
std::string number_markup(double value);

}  // namespace plumb
