#pragma once

#include "render/image/image.h"

namespace plumb {

/// The picture in small: no wider than `width` (> 0), its pixels the means, in linear light, of those that
/// they cover, and its colours in so few steps that it takes little room as a PNG. What is not opaque is laid
/// over white. A picture that is no wider keeps its size.
Image thumbnail(const Image& image, int width);

}  // namespace plumb
