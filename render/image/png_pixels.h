#pragma once

#include <cstdint>
#include <string>

#include "render/image/image.h"
#include "render/image/png_file.h"

namespace plumb {

/// Decoded pixels.
struct PngPixels {
  Image image;
  /// Of 16 bits a channel, tells what the picture's 8 bits do not hold from that of others; 0: nothing.
  std::uint64_t finer = 0;
};

/// The still picture of a file, and one of its frames without what it covers. Colours are those of the
/// file's own colour space, not multiplied by their opacities. Throw InputError that names `name` on bad
/// data, and Interrupted.
PngPixels decode_still(const PngFile& file, const std::string& name);
PngPixels decode_frame(const PngFile& file, const PngFrame& frame, const std::string& name);

/// The frame as a PNG file of its own, without what it covers.
std::string png_of_frame(const PngFile& file, const PngFrame& frame);

}  // namespace plumb
