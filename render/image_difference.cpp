#include "render/image_difference.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>
#include <vector>

namespace plumb {
namespace {

int greatest_channel(const std::uint8_t* a, const std::uint8_t* b) {
  int greatest = 0;
  for (int c = 0; c < 3; ++c) greatest = std::max(greatest, std::abs(int{a[c]} - int{b[c]}));
  return greatest;
}

std::size_t pixels(const Image& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// Finds the window with most of the marked pixels, by sums over all pixels above and to the left.
void find_densest(const std::vector<std::uint8_t>& marked, int width, int height, ImageDifference& result) {
  const auto stride = static_cast<std::size_t>(width) + 1;
  std::vector<int> sums(stride * (static_cast<std::size_t>(height) + 1), 0);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    int row = 0;
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
      row += marked[y * static_cast<std::size_t>(width) + x];
      sums[(y + 1) * stride + x + 1] = sums[y * stride + x + 1] + row;
    }
  }
  const int wide = std::min(width, difference_window), high = std::min(height, difference_window);
  const auto at = [&](int x, int y) {
    return sums[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)];
  };
  int most = 0;
  for (int y = 0; y + high <= height; ++y)
    for (int x = 0; x + wide <= width; ++x) {
      const int count = at(x + wide, y + high) - at(x, y + high) - at(x + wide, y) + at(x, y);
      if (count <= most) continue;
      most = count;
      result.x = x;
      result.y = y;
    }
  result.density = static_cast<double>(most) / (wide * high);
}

unsigned packed(const std::uint8_t* p) {
  return unsigned{p[0]} << 16U | unsigned{p[1]} << 8U | p[2];
}

/// The commonest colour of two pictures: what they are drawn on.
unsigned background(const Image& a, const Image& b) {
  std::unordered_map<unsigned, long> counts;
  for (const Image* image : {&a, &b})
    for (std::size_t i = 0; i < image->rgb.size(); i += 3) ++counts[packed(&image->rgb[i])];
  unsigned commonest = 0xFFFFFF;
  long most = 0;
  for (const auto& [color, count] : counts)
    if (count > most || (count == most && color < commonest)) {
      most = count;
      commonest = color;
    }
  return commonest;
}

}  // namespace

ImageDifference difference(const Image& a, const Image& b, const DifferenceTolerance& tolerance) {
  ImageDifference result;
  result.same_size = a.width == b.width && a.height == b.height;
  if (!result.same_size || a.rgb.empty()) return result;
  std::vector<std::uint8_t> marked(pixels(a));
  for (std::size_t i = 0; i < marked.size(); ++i) {
    const int levels = greatest_channel(&a.rgb[3 * i], &b.rgb[3 * i]);
    result.greatest = std::max(result.greatest, levels);
    if (levels > 0) ++result.changed;
    marked[i] = levels > tolerance.channel ? 1 : 0;
    result.beyond += marked[i];
  }
  if (result.beyond > 0) find_densest(marked, a.width, a.height, result);
  return result;
}

Image difference_image(const Image& a, const Image& b, const DifferenceTolerance& tolerance) {
  constexpr std::uint8_t blue[3] = {0x00, 0x72, 0xB2}, red[3] = {0xD5, 0x30, 0x00};
  const unsigned on = background(a, b);
  const std::uint8_t ground[3] = {static_cast<std::uint8_t>(on >> 16U), static_cast<std::uint8_t>(on >> 8U),
                                  static_cast<std::uint8_t>(on)};
  Image result{b.width, b.height, std::vector<std::uint8_t>(b.rgb.size())};
  for (std::size_t i = 0; i < b.rgb.size(); i += 3) {
    if (greatest_channel(&a.rgb[i], &b.rgb[i]) > tolerance.channel) {
      const bool added = greatest_channel(&b.rgb[i], ground) >= greatest_channel(&a.rgb[i], ground);
      std::copy_n(added ? blue : red, 3, &result.rgb[i]);
      continue;
    }
    const int gray = (b.rgb[i] * 2 + b.rgb[i + 1] * 5 + b.rgb[i + 2]) / 8;
    std::fill_n(&result.rgb[i], 3, static_cast<std::uint8_t>(255 - (255 - gray) / 4));
  }
  return result;
}

}  // namespace plumb
