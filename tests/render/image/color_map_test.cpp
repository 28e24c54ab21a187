#include "render/image/color_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace plumb {
namespace color_map_test {

/// CIE lightness of an sRGB colour.
double lightness(Color color) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColorMap, IsViridisAsPublished) {
  // Ten colours evenly along the map, as R's viridisLite gives them.
  constexpr std::array<unsigned, 10> published = {0x440154, 0x482878, 0x3E4A89, 0x31688E, 0x26828E,
                                                  0x1F9E89, 0x35B779, 0x6DCD59, 0xB4DE2C, 0xFDE725};
  for (std::size_t k = 0; k < published.size(); ++k) {
    const Color expected = Color::hex(published[k]);
    const Color color = map_color(static_cast<double>(k) / 9);
    EXPECT_NEAR(color.r, expected.r, 0.02) << k;
    EXPECT_NEAR(color.g, expected.g, 0.02) << k;
    EXPECT_NEAR(color.b, expected.b, 0.02) << k;
  }
}

TEST(DivergingMap, DarkensEvenlyAndAlikeToEitherSideOfNearWhite) {
  const double middle = lightness(diverging_map_color(0.5));
  EXPECT_GT(middle, 92);
  for (int k = 0; k < 16; ++k) {
    const double near = 0.5 * k / 16, far = 0.5 * (k + 1) / 16;
    const double below = lightness(diverging_map_color(0.5 - far)),
                 above = lightness(diverging_map_color(0.5 + far));
    EXPECT_NEAR(below, above, 6) << k;
    for (const double side : {-1.0, 1.0}) {
      const double step = lightness(diverging_map_color(0.5 + side * near)) -
                          lightness(diverging_map_color(0.5 + side * far));
      EXPECT_GT(step, 0.5 * (middle - 30) / 16) << k;
      EXPECT_LT(step, 1.6 * (middle - 30) / 16) << k;
    }
  }
  EXPECT_GT(diverging_map_color(0).b, diverging_map_color(0).r + 0.2) << "blue";
  EXPECT_GT(diverging_map_color(1).r, diverging_map_color(1).b + 0.2) << "red";
  EXPECT_EQ(diverging_map_color(-3), diverging_map_color(0));
  EXPECT_EQ(diverging_map_color(7), diverging_map_color(1));
}

TEST(ColorMap, GrowsLighterEvenly) {
  const double whole = lightness(map_color(1)) - lightness(map_color(0));
  EXPECT_GT(whole, 70);
  for (int k = 0; k < 32; ++k) {
    const double step = lightness(map_color((k + 1) / 32.0)) - lightness(map_color(k / 32.0));
    EXPECT_GT(step, 0.5 * whole / 32) << k;
    EXPECT_LT(step, 1.5 * whole / 32) << k;
  }
}

TEST(ColorMap, EndsAtItsEnds) {
  EXPECT_EQ(map_color(-3), map_color(0));
  EXPECT_EQ(map_color(7), map_color(1));
}

}  // namespace color_map_test
}  // namespace plumb
