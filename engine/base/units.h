#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// What a number in `unit` is multiplied by to be in `base`, one of the units that Plumb computes in: "s",
/// "m", "m/s", "1", "N", "1/m", "N m". Blanks and the signs ·, * and - between parts of a unit are alike, so
/// that "Nmm", "N mm" and "N*mm" are one. Nothing for a unit that is unknown or of another dimension.
std::optional<double> unit_factor(std::string_view unit, std::string_view base);

/// The units of the same dimension as `base`, as they are written.
std::vector<std::string> units_like(std::string_view base);

/// What is wrong with a unit that has no factor: "is a unit of time, not of length; allowed: m, mm, …", or
/// "is no known unit; did you mean "mm"? Allowed: m, mm, …".
std::string unit_fault(std::string_view unit, std::string_view base);

}  // namespace plumb
