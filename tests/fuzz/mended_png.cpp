#include "tests/fuzz/mended_png.h"

#include "render/image/png_chunks.h"

namespace plumb::fuzz {

std::string mended_png(std::string_view bytes) {
  constexpr std::size_t around = 12;  // length, type and check sum
  std::string mended(png_signature);
  std::string_view rest = bytes.substr(std::min(bytes.size(), png_signature.size()));
  while (rest.size() >= around) {
    const std::size_t length = std::min<std::size_t>(read_u32(rest), rest.size() - around);
    append_chunk(mended, rest.substr(4, 4), rest.substr(8, length));
    rest.remove_prefix(around + length);
  }
  return mended;
}

Image small_image(int width, int height, bool opaque, unsigned shade) {
  Image image{width, height, {}, {}};
  const auto pixels = static_cast<unsigned>(width * height);
  for (unsigned k = 0; k < 3 * pixels; ++k) image.rgb.push_back(static_cast<std::uint8_t>(shade + 7 * k));
  for (unsigned k = 0; !opaque && k < pixels; ++k) image.alpha.push_back(static_cast<std::uint8_t>(40 * k));
  return image;
}

}  // namespace plumb::fuzz
