#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/image/image.h"

namespace plumb {

/// Keywords (1 to 79 Latin-1 letters) and texts for a PNG's tEXt chunks: "Software", "Description", …
using PngTexts = std::vector<std::pair<std::string, std::string>>;

/// The keyword of the text that says what drew a picture: GlInfo::fingerprint().
inline constexpr const char* renderer_keyword = "Renderer";

/// What encoding is to save.
enum class PngEffort {
  small,  ///< bytes: for figures and what is put into a page
  quick,  ///< time: for frames, some 15 % larger in half the time
  page,   ///< bytes before fidelity: an opaque picture in at most 256 colours, in less than half the bytes
};

/// The bytes of a PNG file, 8 bits a channel, RGB or, of a picture with opacities, RGBA, or with a
/// palette (few_colors.h); the same for the same picture, texts and effort. Throws OutputError when the
/// picture is empty or libpng refuses it.
std::string encode_png(const Image& image, const PngTexts& texts = {}, PngEffort effort = PngEffort::small);

/// The still picture in the bytes of a PNG file of any kind, with 8 bits a channel and its opacities, in the
/// file's own colour space. Throws InputError that names `name` on bad data or more pixels than are read,
/// and Interrupted.
Image decode_png(std::string_view bytes, const std::string& name);

/// The text of a keyword in the bytes of a PNG file; nothing where it has none. Throws InputError that names
/// `name` on bad data.
std::optional<std::string> text_in_png(std::string_view bytes, const std::string& keyword,
                                       const std::string& name);

}  // namespace plumb
