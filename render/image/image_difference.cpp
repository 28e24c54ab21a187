#include "render/image/image_difference.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>
#include <vector>

#include "engine/base/interrupt.h"

namespace plumb {
namespace {

constexpr int opaque = 255;

std::size_t pixels(const Image& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

int alpha_of(const Image& image, std::size_t pixel) {
  return image.alpha.empty() ? opaque : image.alpha[pixel];
}

/// Levels by which a pixel differs in any channel, seen on black or on white: of one that is not opaque what
/// is seen depends on the ground, and between these two lie all others. Less than a level counts as one.
int greatest_channel(const Image& a, const Image& b, std::size_t pixel) {
  const std::uint8_t *one = &a.rgb[3 * pixel], *other = &b.rgb[3 * pixel];
  const int alpha = alpha_of(a, pixel), other_alpha = alpha_of(b, pixel);
  const int ground = opaque * (alpha - other_alpha);
  int greatest = 0;
  for (int c = 0; c < 3; ++c) {
    const int on_black = one[c] * alpha - other[c] * other_alpha;
    greatest = std::max({greatest, std::abs(on_black), std::abs(on_black - ground)});
  }
  return (greatest + opaque - 1) / opaque;
}

/// A picture with opacities on white; nothing of one that has none.
Image on_white(const Image& image) {
  if (image.alpha.empty()) return {};
  Image result{image.width, image.height, image.rgb};
  for (std::size_t i = 0; i < image.alpha.size(); ++i)
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      result.rgb[c] = static_cast<std::uint8_t>(
          (image.rgb[c] * image.alpha[i] + opaque * (opaque - image.alpha[i]) + opaque / 2) / opaque);
  return result;
}

int greatest_channel(const std::uint8_t* a, const std::uint8_t* b) {
  int greatest = 0;
  for (int c = 0; c < 3; ++c) greatest = std::max(greatest, std::abs(int{a[c]} - int{b[c]}));
  return greatest;
}

void stop_now_and_then(std::size_t pixel) {
  constexpr std::size_t pixels_at_a_time = 1U << 16;
  if (pixel % pixels_at_a_time == 0) stop_if_interrupted();
}

/// Finds the window with most of the marked pixels: counts of the marked pixels in each column of a band of
/// rows that moves down, and of a window that moves along it.
void find_densest(const std::vector<std::uint8_t>& marked, int width, int height, ImageDifference& result) {
  const int wide = std::min(width, difference_window), high = std::min(height, difference_window);
  const auto at = [&](int x, int y) {
    return int{
        marked[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]};
  };
  std::vector<int> columns(static_cast<std::size_t>(width), 0);
  int most = 0;
  for (int bottom = 0; bottom < height; ++bottom) {
    stop_if_interrupted();
    int count = 0;
    for (int right = 0; right < width; ++right) {
      int& column = columns[static_cast<std::size_t>(right)];
      column += at(right, bottom) - (bottom >= high ? at(right, bottom - high) : 0);
      count += column - (right >= wide ? columns[static_cast<std::size_t>(right - wide)] : 0);
      if (bottom + 1 < high || right + 1 < wide || count <= most) continue;
      most = count;
      result.x = right + 1 - wide;
      result.y = bottom + 1 - high;
    }
  }
  result.density = static_cast<double>(most) / (wide * high);
}

unsigned packed(const std::uint8_t* p) {
  return unsigned{p[0]} << 16U | unsigned{p[1]} << 8U | p[2];
}

/// The commonest colour of two pictures, among many of their pixels: what they are drawn on.
unsigned background(const Image& a, const Image& b) {
  constexpr std::size_t enough = 1U << 18;
  std::unordered_map<unsigned, long> counts;
  for (const Image* image : {&a, &b}) {
    const std::size_t step = pixels(*image) / enough + 1;
    for (std::size_t i = 0; i < pixels(*image); i += step) ++counts[packed(&image->rgb[3 * i])];
  }
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
    stop_now_and_then(i);
    const int levels = greatest_channel(a, b, i);
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
  const Image flat_a = on_white(a), flat_b = on_white(b);
  const Image &seen_a = a.alpha.empty() ? a : flat_a, &seen_b = b.alpha.empty() ? b : flat_b;
  const unsigned on = background(seen_a, seen_b);
  const std::uint8_t ground[3] = {static_cast<std::uint8_t>(on >> 16U), static_cast<std::uint8_t>(on >> 8U),
                                  static_cast<std::uint8_t>(on)};
  Image result{b.width, b.height, std::vector<std::uint8_t>(b.rgb.size())};
  for (std::size_t i = 0; i < pixels(b); ++i) {
    stop_now_and_then(i);
    const std::uint8_t *one = &seen_a.rgb[3 * i], *other = &seen_b.rgb[3 * i];
    if (greatest_channel(a, b, i) > tolerance.channel) {
      const bool added = greatest_channel(other, ground) >= greatest_channel(one, ground);
      std::copy_n(added ? blue : red, 3, &result.rgb[3 * i]);
      continue;
    }
    const int gray = (other[0] * 2 + other[1] * 5 + other[2]) / 8;
    std::fill_n(&result.rgb[3 * i], 3, static_cast<std::uint8_t>(255 - (255 - gray) / 4));
  }
  return result;
}

}  // namespace plumb
