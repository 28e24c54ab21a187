#include "report/figure/number_markup.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "render/gl/markup.h"

namespace plumb {

std::string unit_markup(std::string_view unit) {
  const std::size_t slash = unit.find('/');
  if (slash == unit.npos || slash == 0 || unit.find('/', slash + 1) != unit.npos) return literal(unit);
  const std::string_view above = unit.substr(0, slash), below = unit.substr(slash + 1);
  std::size_t letters = 0;
  while (letters < below.size() && std::isalpha(static_cast<unsigned char>(below[letters])) != 0) ++letters;
  // "s", "s2" and "s^2" alike.
  std::string_view power = below.substr(letters);
  if (power.starts_with('^')) power.remove_prefix(1);
  const bool plain = power.empty() || (power.size() == 1 && power[0] >= '2' && power[0] <= '9');
  if (letters == 0 || !plain) return literal(unit);
  return fmt::format("{}{}^{{-{}}}", above == "1" ? "" : literal(above) + " ", below.substr(0, letters),
                     power.empty() ? "1" : power);
}

std::string number_markup(double value) {
  if (value == 0 || !std::isfinite(value)) return fmt::format("{:.2g}", value);
  const int power = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (power >= -2 && power < 4) return fmt::format("{:.2g}", value);
  return fmt::format("{:.1f}·10^{{{}}}", value / std::pow(10.0, power), power);
}

}  // namespace plumb
