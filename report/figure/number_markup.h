#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// A unit as the labels of figures write it (markup.h): "m/s" is "m s^{-1}", "1/m" is "m^{-1}", "kg/m³" is
/// "kg m^{-3}". Others stay.
std::string unit_markup(std::string_view unit);
/// The same as pages and charts write it: "m s⁻¹".
std::string unit_text(std::string_view unit);
/// " m s⁻¹" after a number; empty for the unit 1, which is not written.
std::string unit_after(std::string_view unit);

/// Markup as plain text: digits and minus signs that are raised or lowered as such signs, "10⁻³", "ω₁", other
/// letters as they are.
std::string plain_text(std::string_view markup);

/// A number as the labels of figures write it: "3.1·10^{−12}", or "0.031".
std::string number_markup(double value);

}  // namespace plumb
