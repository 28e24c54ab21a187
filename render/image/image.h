#pragma once

#include <cstdint>
#include <vector>

namespace plumb {

/// A picture: 8-bit sRGB, rows from the top, three bytes a pixel without padding, and opacities where it is
/// not opaque, by which the colours are not multiplied.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;         ///< 3 · width · height bytes
  std::vector<std::uint8_t> alpha = {};  ///< width · height bytes, 255 being opaque; none: all of it is

  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace plumb
