#include "render/image/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {
namespace {

using Oklab = std::array<double, 3>;  // lightness, green to red, blue to yellow

Color from_oklab(const Oklab& c) {
  // B. Ottosson, "A perceptual color space for image processing", 2020.
  const auto cubed = [&](double a, double b) { return std::pow(c[0] + a * c[1] + b * c[2], 3); };
  const double l = cubed(0.3963377774, 0.2158037573), m = cubed(-0.1055613458, -0.0638541728),
               s = cubed(-0.0894841775, -1.2914855480);
  const auto coded = [](double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
  };
  return {coded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          coded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          coded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Color map_color(double value) {
  // M. Zucker's polynomials (shadertoy.com/view/WlfXRN, 2019, public domain), within 0.01 of the map's table.
  using Coefficients = std::array<double, 7>;
  constexpr Coefficients red = {0.2777273272234177, 0.1050930431085774, -0.3308618287255563,
                                -4.634230498983486, 6.228269936347081,  4.776384997670288,
                                -5.435455855934631};
  constexpr Coefficients green = {0.005407344544966578, 1.404613529898575, 0.214847559468213,
                                  -5.799100973351585,   14.17993336680509, -13.74514537774601,
                                  4.645852612178535};
  constexpr Coefficients blue = {0.3340998053353061, 1.384590162594685, 0.09509516302823659,
                                 -19.33244095627987, 56.69055260068105, -65.35303263337234,
                                 26.3124352495832};
  const double t = std::clamp(value, 0.0, 1.0);
  const auto at = [t](const Coefficients& c) {
    double sum = 0;
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * t + c[k];
    return static_cast<float>(std::clamp(sum, 0.0, 1.0));
  };
  return {at(red), at(green), at(blue)};
}

Color diverging_map_color(double value) {
  constexpr Oklab low = {0.40, -0.04, -0.115}, middle = {0.97, 0, 0}, high = {0.40, 0.10, 0.08};
  const double t = 2 * std::clamp(value, 0.0, 1.0) - 1;
  const Oklab& end = t < 0 ? low : high;
  Oklab mixed{};
  for (std::size_t k = 0; k < mixed.size(); ++k) mixed[k] = std::lerp(middle[k], end[k], std::abs(t));
  return from_oklab(mixed);
}

}  // namespace plumb
