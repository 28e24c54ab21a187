#include "render/image/few_colors.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace plumb {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr std::size_t most_colors = 256;

Rgb color_at(const Image& image, std::size_t pixel) {
  return {image.rgb[3 * pixel], image.rgb[3 * pixel + 1], image.rgb[3 * pixel + 2]};
}

/// The upper four bits of each part.
std::uint32_t group_of(const Rgb& color) {
  std::uint32_t group = 0;
  for (const std::uint8_t part : color) group = group << 4U | std::uint32_t{part} >> 4U;
  return group;
}

struct Group {
  std::uint32_t key = 0;
  std::size_t pixels = 0;
  Rgb color{};            // its most frequent
  std::size_t often = 0;  // so many pixels have it
};

std::vector<Group> groups_of(const Image& image, std::size_t pixels) {
  std::unordered_map<std::uint32_t, std::size_t> counts;
  const auto packed = [](const Rgb& color) {
    return std::uint32_t{color[0]} << 16U | std::uint32_t{color[1]} << 8U | color[2];
  };
  for (std::size_t k = 0; k < pixels; ++k) ++counts[packed(color_at(image, k))];
  std::vector<Group> by_key(1U << 12U);
  for (const auto& [color, count] : counts) {
    const Rgb rgb{static_cast<std::uint8_t>(color >> 16U), static_cast<std::uint8_t>(color >> 8U),
                  static_cast<std::uint8_t>(color)};
    Group& group = by_key[group_of(rgb)];
    group.key = group_of(rgb);
    group.pixels += count;
    // Of two that are as frequent the darker, whatever the order in which they are met.
    if (count > group.often || (count == group.often && rgb < group.color)) {
      group.color = rgb;
      group.often = count;
    }
  }
  std::erase_if(by_key, [](const Group& group) { return group.pixels == 0; });
  return by_key;
}

int distance(const Rgb& a, const Rgb& b) {
  int sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

std::uint8_t nearest(const std::vector<Rgb>& colors, const Rgb& color) {
  std::size_t best = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t k = 0; k < colors.size(); ++k)
    if (const int d = distance(colors[k], color); d < least) {
      least = d;
      best = k;
    }
  return static_cast<std::uint8_t>(best);
}

}  // namespace

FewColors in_few_colors(const Image& image) {
  const std::size_t pixels = image.rgb.size() / 3;
  std::vector<Group> groups = groups_of(image, pixels);
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.pixels > b.pixels; });
  FewColors result;
  for (std::size_t k = 0; k < std::min(groups.size(), most_colors); ++k)
    result.colors.push_back(groups[k].color);
  std::vector<std::uint8_t> places(1U << 12U);
  for (const Group& group : groups) places[group.key] = nearest(result.colors, group.color);
  result.pixels.reserve(pixels);
  for (std::size_t k = 0; k < pixels; ++k) result.pixels.push_back(places[group_of(color_at(image, k))]);
  return result;
}

}  // namespace plumb
