#include "render/image/tiles.h"

#include <algorithm>

namespace plumb {

std::vector<Tile> tiles_of(int width, int height, int most) {
  const int wide = std::min(width, most), high = std::min(height, most);
  std::vector<Tile> tiles;
  for (int top = 0; top < height; top += high)
    for (int left = 0; left < width; left += wide) tiles.push_back({left, top, wide, high});
  return tiles;
}

Color tile_transform(const Tile& tile, int width, int height) {
  const double w = tile.width, h = tile.height;
  return {static_cast<float>(width / w), static_cast<float>(height / h),
          static_cast<float>((width - 2.0 * tile.left) / w - 1),
          static_cast<float>(1 - (height - 2.0 * tile.top) / h)};
}

}  // namespace plumb
