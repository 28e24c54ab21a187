#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// A unit as the labels of figures write it (markup.h): "m/s" is "m s^{-1}", "1/m" is "m^{-1}". Others stay.
std::string unit_markup(std::string_view unit);

}  // namespace plumb
