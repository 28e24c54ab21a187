#include "render/color_map.h"

#include <algorithm>
#include <array>

namespace plumb {

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

}  // namespace plumb
