#pragma once

#include <cstdint>
#include <vector>

namespace plumb {

/// A picture: 8-bit sRGB, rows from the top, three bytes a pixel without padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 · width · height bytes

  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace plumb
