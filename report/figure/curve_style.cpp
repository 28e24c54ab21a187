#include "report/figure/curve_style.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace plumb {
namespace {

/// Three shades of a hue: of the palette's, told apart with any of the common colour blindnesses.
using Shades = std::array<Color, 3>;

struct FamilyColors {
  Shades on_white;
  Shades on_dark;
};

FamilyColors colors_of(MethodFamily family) {
  const auto shades = [](unsigned a, unsigned b, unsigned c) {
    return Shades{Color::hex(a), Color::hex(b), Color::hex(c)};
  };
  switch (family) {
    case MethodFamily::explicit_one_step:
      return {shades(0x0072B2, 0x003E73, 0x3D9BE0), shades(0x56B4E9, 0xA5D8F7, 0x2F8FD0)};
    case MethodFamily::structural:
      return {shades(0xD55E00, 0x8A3800, 0xE58A2B), shades(0xFF9A4D, 0xFFCFA3, 0xE0701A)};
    case MethodFamily::implicit_stages:
      return {shades(0x00875F, 0x00503A, 0x2FB089), shades(0x3FCF9F, 0xA6ECD2, 0x1FA37A)};
    case MethodFamily::multistep:
      return {shades(0xB04A85, 0x6B2450, 0xD687B2), shades(0xE59AC4, 0xF6D3E6, 0xC466A0)};
    case MethodFamily::constrained:
    case MethodFamily::quasi_static:  // never among the curves of a study
    case MethodFamily::modal:
      break;
  }
  return {shades(0x222222, 0x666666, 0x8C8C8C), shades(0xF0F0F0, 0xBDBDBD, 0x8F8F8F)};
}

}  // namespace

std::map<std::string, CurveStyle> curve_styles(const WorkPrecision& study) {
  constexpr std::array markers = {Marker::circle, Marker::square, Marker::diamond, Marker::triangle_up,
                                  Marker::triangle_down};
  constexpr std::array dashes = {Dash::solid, Dash::dashed, Dash::dotted};
  std::map<std::string, CurveStyle> styles;
  std::map<MethodFamily, std::size_t> members;
  for (const MethodCurve& curve : study.curves) {
    if (styles.contains(curve.label)) continue;
    const std::size_t k = members[curve.family]++;
    const FamilyColors colors = colors_of(curve.family);
    // Shades and markers change together, as 3 and 5 have no common divisor; dashes and filling tell the
    // next 15 and 45.
    styles[curve.label] = {colors.on_white[k % colors.on_white.size()],
                           colors.on_dark[k % colors.on_dark.size()], markers[k % markers.size()],
                           k / 15 % 2 == 1, dashes[(k / 3 + k / 30) % dashes.size()]};
  }
  return styles;
}

CurveStyle given_style(const WorkPrecision& study, std::size_t k) {
  constexpr std::array<unsigned, 3> on_white{0x6A3D9A, 0x3A1B66, 0x9C6FD6};
  constexpr std::array<unsigned, 3> on_dark{0xB794F4, 0xDDCCFB, 0x9068DC};
  constexpr std::array dashes = {Dash::solid, Dash::dashed, Dash::dotted};
  const GivenCurve& curve = study.given_curves[k];
  return {Color::hex(on_white[k % on_white.size()]), Color::hex(on_dark[k % on_dark.size()]),
          Marker::triangle_right, curve.is_elsewhere() && !study.is_scaled(curve),
          dashes[k / on_white.size() % dashes.size()]};
}

std::string css(Color color) {
  const auto byte = [](float share) { return static_cast<unsigned>(std::lround(255 * share)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
}

}  // namespace plumb
