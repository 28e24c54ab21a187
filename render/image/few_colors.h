#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/image/image.h"

namespace plumb {

/// A picture as places in a list of colours.
struct FewColors {
  std::vector<std::array<std::uint8_t, 3>> colors;  ///< 1 to 256
  std::vector<std::uint8_t> pixels;                 ///< rows from the top, a place in `colors` each
};

/// The opaque picture in at most 256 of its own colours. Of colours that agree in their upper four bits the
/// most frequent stands for all, so that paper, ink and the colours of lines stay as they are; where these
/// are still too many, the rarest become the nearest of the others.
FewColors in_few_colors(const Image& image);

}  // namespace plumb
