#include "render/image/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {
namespace {

constexpr int channels = 3;

/// IEC 61966-2-1, 5.2.
double linear_of(int level) {
  const double value = level / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The nearest of 32 levels.
std::uint8_t coarse_level(double linear) {
  constexpr double steps = 31;
  const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(
      std::lround(std::round(std::clamp(value, 0.0, 1.0) * steps) * 255 / steps));
}

}  // namespace

Image thumbnail(const Image& image, int width) {
  std::array<double, 256> linear{};
  for (int level = 0; level < 256; ++level) linear[static_cast<std::size_t>(level)] = linear_of(level);
  Image small;
  small.width = std::min(width, image.width);
  small.height = std::max(
      1, static_cast<int>(std::lround(static_cast<double>(image.height) * small.width / image.width)));
  small.rgb.reserve(static_cast<std::size_t>(channels * small.width * small.height));
  // Whole pixels only: a pixel belongs to where its corner lies.
  const auto begin = [](int k, int of, int from) { return static_cast<int>(std::int64_t{k} * from / of); };
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      std::array<double, channels> sum{};
      const int top = begin(y, small.height, image.height), left = begin(x, small.width, image.width);
      const int bottom = std::max(top + 1, begin(y + 1, small.height, image.height)),
                right = std::max(left + 1, begin(x + 1, small.width, image.width));
      for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) {
          const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                    static_cast<std::size_t>(column);
          const double opacity = image.alpha.empty() ? 1 : image.alpha[pixel] / 255.0;
          for (std::size_t c = 0; c < channels; ++c)
            sum[c] += opacity * linear[image.rgb[channels * pixel + c]] + (1 - opacity);
        }
      for (const double value : sum)
        small.rgb.push_back(coarse_level(value / ((bottom - top) * (right - left))));
    }
  return small;
}

}  // namespace plumb
