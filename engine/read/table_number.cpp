#include "engine/read/table_number.h"

#include <charconv>
#include <cmath>
#include <string>

namespace plumb {
namespace {

constexpr std::string_view digits = "0123456789";

/// Where the exponent of Fortran begins, and whether a letter is there to be replaced; npos: it has none.
struct FortranExponent {
  std::size_t at = std::string_view::npos;
  bool letter = false;
};

FortranExponent fortran_exponent(std::string_view text) {
  const std::size_t letter = text.find_first_of("dDqQ");
  const bool has_letter = letter != std::string_view::npos;
  const std::size_t sign = text.find_first_of("+-", 1);
  const std::size_t at = has_letter ? letter : sign;
  if (at == std::string_view::npos || at == 0) return {};
  std::string_view mantissa = text.substr(0, at), exponent = text.substr(at + (has_letter ? 1 : 0));
  if (mantissa.starts_with('+') || mantissa.starts_with('-')) mantissa.remove_prefix(1);
  if (exponent.starts_with('+') || exponent.starts_with('-')) exponent.remove_prefix(1);
  const std::size_t point = mantissa.find('.');
  // A date, 2024-01, has no point.
  if (!has_letter && point == std::string_view::npos) return {};
  std::string all(mantissa);
  if (point != std::string_view::npos) all.erase(point, 1);
  if (all.empty() || all.find_first_not_of(digits) != std::string::npos || exponent.empty() ||
      exponent.find_first_not_of(digits) != std::string_view::npos)
    return {};
  return {at, has_letter};
}

std::optional<double> plain_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range && end == text.data() + text.size()) return HUGE_VAL;
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

bool has_fortran_exponent(std::string_view text) {
  return fortran_exponent(text).at != std::string_view::npos;
}

std::optional<double> table_number(std::string_view text) {
  if (const std::optional<double> value = plain_number(text)) return value;
  const FortranExponent exponent = fortran_exponent(text);
  if (exponent.at == std::string_view::npos) return {};
  std::string usual(text);
  usual.replace(exponent.at, exponent.letter ? 1 : 0, "e");
  return plain_number(usual);
}

}  // namespace plumb
