#pragma once

#include <string>
#include <string_view>

#include "render/image/image.h"

namespace plumb::fuzz {

/// A PNG file with the right check sum at every chunk, as far as it has chunks: what is behind the check sums
/// would otherwise hardly be reached by chance.
std::string mended_png(std::string_view bytes);

/// A picture of a few pixels, with opacities or without.
Image small_image(int width, int height, bool opaque, unsigned shade);

}  // namespace plumb::fuzz
