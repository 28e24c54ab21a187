#include "report/figure/number_markup.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>

#include "render/gl/markup.h"

namespace plumb {
namespace {

constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"},
    lowered{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
constexpr std::string_view minus_sign = "−";

/// "2" for "2", "^2" and "²"; nothing for what is no such power.
std::string_view power_in(std::string_view text) {
  static constexpr std::string_view digits = "0123456789";
  for (std::size_t digit = 2; digit < raised.size(); ++digit)
    if (text == raised[digit]) return digits.substr(digit, 1);
  if (text.starts_with('^')) text.remove_prefix(1);
  return text.size() == 1 && text[0] >= '2' && text[0] <= '9' ? text : std::string_view();
}

std::string in_script(std::string_view text, Script script) {
  const auto& signs = script == Script::above ? raised : lowered;
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] >= '0' && text[k] <= '9') {
      result += signs[static_cast<std::size_t>(text[k] - '0')];
    } else if (text.substr(k).starts_with(minus_sign)) {
      result += script == Script::above ? "⁻" : "₋";
      k += minus_sign.size() - 1;
    } else {
      result += text[k];
    }
  }
  return result;
}

}  // namespace

std::string plain_text(std::string_view markup) {
  std::string text;
  for (const TextRun& run : read_markup(markup))
    text += run.script == Script::none ? run.text : in_script(run.text, run.script);
  return text;
}

std::string unit_text(std::string_view unit) {
  return plain_text(unit_markup(unit));
}

std::string unit_after(std::string_view unit) {
  return unit == "1" || unit.empty() ? "" : " " + unit_text(unit);
}

std::string unit_markup(std::string_view unit) {
  const std::size_t slash = unit.find('/');
  if (slash == unit.npos || slash == 0 || unit.find('/', slash + 1) != unit.npos) return literal(unit);
  const std::string_view above = unit.substr(0, slash), below = unit.substr(slash + 1);
  std::size_t letters = 0;
  while (letters < below.size() && std::isalpha(static_cast<unsigned char>(below[letters])) != 0) ++letters;
  const std::string_view rest = below.substr(letters), power = power_in(rest);
  if (letters == 0 || (power.empty() && !rest.empty())) return literal(unit);
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
