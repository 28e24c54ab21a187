#pragma once

#include <vector>

#include "render/image/color.h"

namespace plumb {

/// A part of a picture, pixels.
struct Tile {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

/// The tiles that cover a picture, all as large as the first, so that those at its right and bottom reach
/// beyond it; a picture of at most `most` ≥ 1 pixels a side is one tile.
std::vector<Tile> tiles_of(int width, int height, int most);

/// What takes clip coordinates (x, y, w) of a picture to those of a tile: x · r + w · b, y · g + w · a.
Color tile_transform(const Tile& tile, int width, int height);

}  // namespace plumb
