#pragma once

#include <array>

namespace plumb {

/// sRGB components and opacity, 0 to 1.
struct Color {
  float r = 0;
  float g = 0;
  float b = 0;
  float a = 1;

  /// From 0xRRGGBB.
  static constexpr Color hex(unsigned rgb, float alpha = 1) {
    return {static_cast<float>((rgb >> 16) & 255U) / 255.0F, static_cast<float>((rgb >> 8) & 255U) / 255.0F,
            static_cast<float>(rgb & 255U) / 255.0F, alpha};
  }

  friend bool operator==(const Color&, const Color&) = default;
};

/// Colours that people with any of the common colour blindnesses tell apart (Okabe and Ito 2008), the yellow
/// left out as it is too faint on white: blue, vermillion, green, purple, orange, sky blue, black.
inline constexpr std::array<Color, 7> palette = {
    Color::hex(0x0072B2), Color::hex(0xD55E00), Color::hex(0x009E73), Color::hex(0xCC79A7),
    Color::hex(0xE69F00), Color::hex(0x56B4E9), Color::hex(0x000000)};

}  // namespace plumb
