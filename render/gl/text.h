#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

enum class Weight { regular, bold };

struct TextStyle {
  double size = 16;  ///< em height, pixels, > 0
  Weight weight = Weight::regular;
};

/// Where a text's ink and pen go, pixels.
struct TextExtent {
  double width = 0;    ///< the pen's way
  double ascent = 0;   ///< of the font above the base line, the same for every text of a style
  double descent = 0;  ///< below it, positive
};

/// Coverage of a text, 0 to 255, rows from the top.
struct TextBitmap {
  int width = 0;
  int height = 0;
  int left = 0;  ///< column of the pen's start
  int base = 0;  ///< row of the base line
  std::vector<std::uint8_t> coverage;
};

/// DejaVu Sans, regular and bold. Texts are UTF-8 in one line; bytes that are not become U+FFFD.
/// Superscripts and subscripts are written as markup.h has it: "×10^{-5}", "ω_{max}". Glyphs are not hinted
/// and stand at fractions of a pixel, so that a text's shape does not depend on where it stands or how large
/// it is.
class Font {
 public:
  /// Throws OutputError that names a font file which is missing or cannot be read.
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  TextExtent measure(std::string_view text, TextStyle style) const;
  TextBitmap draw(std::string_view text, TextStyle style) const;

 private:
  class Faces;
  std::unique_ptr<Faces> faces_;
};

/// The library that draws letters, with its version: "FreeType 2.12.1".
std::string font_library();

/// A bitmap turned by 90° against the clock, to be read from the right: `left` and `base` are still the
/// column and row of the pen's start.
TextBitmap turned(const TextBitmap& bitmap);

}  // namespace plumb
