#include "engine/base/units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/nearest.h"

namespace plumb {
namespace {

constexpr double inch = 0.0254, foot = 0.3048;  // m, exactly (international yard and pound agreement, 1959)
constexpr double pound_force = 0.45359237 * 9.80665;  // N, exactly

struct Unit {
  std::string_view name;
  std::string_view base;
  double factor;
};

constexpr std::array units{
    Unit{"s", "s", 1},
    Unit{"ms", "s", 1e-3},
    Unit{"us", "s", 1e-6},
    Unit{"µs", "s", 1e-6},
    Unit{"min", "s", 60},
    Unit{"m", "m", 1},
    Unit{"mm", "m", 1e-3},
    Unit{"cm", "m", 1e-2},
    Unit{"um", "m", 1e-6},
    Unit{"µm", "m", 1e-6},
    Unit{"km", "m", 1e3},
    Unit{"in", "m", inch},
    Unit{"ft", "m", foot},
    Unit{"m/s", "m/s", 1},
    Unit{"mm/s", "m/s", 1e-3},
    Unit{"cm/s", "m/s", 1e-2},
    Unit{"km/h", "m/s", 1 / 3.6},
    Unit{"in/s", "m/s", inch},
    Unit{"ft/s", "m/s", foot},
    Unit{"1", "1", 1},
    Unit{"%", "1", 1e-2},
    Unit{"N", "N", 1},
    Unit{"mN", "N", 1e-3},
    Unit{"kN", "N", 1e3},
    Unit{"lbf", "N", pound_force},
    Unit{"1/m", "1/m", 1},
    Unit{"1/mm", "1/m", 1e3},
    Unit{"1/cm", "1/m", 1e2},
    Unit{"1/in", "1/m", 1 / inch},
    Unit{"1/ft", "1/m", 1 / foot},
    Unit{"N m", "N m", 1},
    Unit{"N mm", "N m", 1e-3},
    Unit{"kN m", "N m", 1e3},
    Unit{"lbf ft", "N m", pound_force* foot},
    Unit{"lbf in", "N m", pound_force* inch},
};

constexpr std::array dimensions{
    std::pair<std::string_view, std::string_view>{"s", "time"},
    std::pair<std::string_view, std::string_view>{"m", "length"},
    std::pair<std::string_view, std::string_view>{"m/s", "speed"},
    std::pair<std::string_view, std::string_view>{"1", "ratio"},
    std::pair<std::string_view, std::string_view>{"N", "force"},
    std::pair<std::string_view, std::string_view>{"1/m", "curvature"},
    std::pair<std::string_view, std::string_view>{"N m", "moment"},
};

std::string_view dimension(std::string_view base) {
  for (const auto& [unit, name] : dimensions)
    if (unit == base) return name;
  return base;
}

/// Without blanks and signs of multiplication, and with one of the two characters that look like µ.
std::string plain(std::string_view unit) {
  constexpr std::array<std::string_view, 5> ignored{" ", "*", "·", "⋅", "-"};
  constexpr std::string_view mu = "μ", micro = "µ";
  std::string result;
  while (!unit.empty()) {
    std::string_view part = unit.substr(0, 1);
    for (const std::string_view sign : ignored)
      if (unit.starts_with(sign)) part = sign;
    const bool dropped = std::find(ignored.begin(), ignored.end(), part) != ignored.end();
    if (unit.starts_with(mu)) {
      part = mu;
      result += micro;
    } else if (!dropped) {
      result += part;
    }
    unit.remove_prefix(part.size());
  }
  return result;
}

const Unit* find_unit(std::string_view name) {
  const std::string wanted = plain(name);
  for (const Unit& unit : units)
    if (plain(unit.name) == wanted) return &unit;
  return nullptr;
}

}  // namespace

std::optional<double> unit_factor(std::string_view unit, std::string_view base) {
  const Unit* found = find_unit(unit);
  if (found == nullptr || found->base != base) return {};
  return found->factor;
}

std::vector<std::string> units_like(std::string_view base) {
  std::vector<std::string> names;
  for (const Unit& unit : units)
    if (unit.base == base) names.emplace_back(unit.name);
  return names;
}

std::string unit_fault(std::string_view unit, std::string_view base) {
  const std::vector<std::string> like = units_like(base);
  const std::string allowed = fmt::format("; allowed: {}", fmt::join(like, ", "));
  if (const Unit* found = find_unit(unit))
    return fmt::format("is a unit of {}, not of {}{}", dimension(found->base), dimension(base), allowed);
  const std::string_view near = nearest(unit, like);
  return "is no known unit" + (near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near)) + allowed;
}

}  // namespace plumb
