#include "render/gl/text.h"

#include <fmt/format.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <string>

#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "engine/base/errors.h"
#include "render/gl/markup.h"
#include "render/gl/utf8.h"

namespace plumb {

namespace {

constexpr double script_scale = 0.68;
constexpr double superscript_rise = 0.36;  // of the em height
constexpr double subscript_rise = -0.16;

void open_face(FT_Library library, const char* path, FT_Face& face) {
  if (FT_New_Face(library, path, 0, &face) != 0)
    throw OutputError(fmt::format("{}: the font file is missing or cannot be read", path));
}

// A glyph with the pen's place before it, pixels, y upwards.
struct Placed {
  FT_UInt glyph;
  double x;
  double y;
  double size;
};

}  // namespace

std::string font_library() {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return "FreeType";
  FT_Int major = 0, minor = 0, patch = 0;
  FT_Library_Version(library, &major, &minor, &patch);
  FT_Done_FreeType(library);
  return fmt::format("FreeType {}.{}.{}", major, minor, patch);
}

class Font::Faces {
 public:
  Faces() {
    if (FT_Init_FreeType(&library_) != 0) throw OutputError("FreeType cannot be started");
    try {
      open_face(library_, PLUMB_FONT, regular_);
      open_face(library_, PLUMB_FONT_BOLD, bold_);
    } catch (...) {
      FT_Done_FreeType(library_);
      throw;
    }
  }
  ~Faces() { FT_Done_FreeType(library_); }  // and its faces
  Faces(const Faces&) = delete;
  Faces& operator=(const Faces&) = delete;

  FT_Face face(Weight weight) const { return weight == Weight::bold ? bold_ : regular_; }

  // Where each glyph goes; returns the pen's whole way.
  double place(std::string_view text, TextStyle style, std::vector<Placed>& placed) const {
    const FT_Face f = face(style.weight);
    double pen = 0;
    for (const TextRun& run : read_markup(text)) {
      const double size = run.script == Script::none ? style.size : style.size * script_scale;
      const double rise = run.script == Script::none    ? 0
                          : run.script == Script::above ? style.size * superscript_rise
                                                        : style.size * subscript_rise;
      const double scale = size / f->units_per_EM;
      FT_UInt previous = 0;
      for (const char32_t point : decode_utf8(run.text)) {
        const FT_UInt glyph = FT_Get_Char_Index(f, point);
        FT_Vector kerning{0, 0};
        if (previous != 0) FT_Get_Kerning(f, previous, glyph, FT_KERNING_UNSCALED, &kerning);
        pen += scale * static_cast<double>(kerning.x);
        placed.push_back({glyph, pen, rise, size});
        if (FT_Load_Glyph(f, glyph, FT_LOAD_NO_SCALE) == 0)
          pen += scale * static_cast<double>(f->glyph->metrics.horiAdvance);
        previous = glyph;
      }
    }
    return pen;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face regular_ = nullptr;
  FT_Face bold_ = nullptr;
};

Font::Font() : faces_(std::make_unique<Faces>()) {}
Font::~Font() = default;

TextExtent Font::measure(std::string_view text, TextStyle style) const {
  const FT_Face face = faces_->face(style.weight);
  const double scale = style.size / face->units_per_EM;
  std::vector<Placed> placed;
  return {faces_->place(text, style, placed), scale * face->ascender, -scale * face->descender};
}

TextBitmap Font::draw(std::string_view text, TextStyle style) const {
  const FT_Face face = faces_->face(style.weight);
  std::vector<Placed> placed;
  const double way = faces_->place(text, style, placed);

  // Glyphs may reach beyond the pen's way and the font's height; half an em around holds every one of
  // DejaVu's.
  const int margin = static_cast<int>(std::ceil(style.size / 2));
  const TextExtent extent = measure(text, style);
  TextBitmap bitmap;
  bitmap.left = margin;
  bitmap.base = margin + static_cast<int>(std::ceil(extent.ascent));
  bitmap.width = 2 * margin + static_cast<int>(std::ceil(way));
  bitmap.height = bitmap.base + static_cast<int>(std::ceil(extent.descent)) + margin;
  bitmap.coverage.assign(static_cast<std::size_t>(bitmap.width) * static_cast<std::size_t>(bitmap.height), 0);

  for (const Placed& p : placed) {
    if (FT_Set_Char_Size(face, 0, std::lround(p.size * 64), 72, 72) != 0 ||
        FT_Load_Glyph(face, p.glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0)
      continue;
    const double whole = std::floor(p.x);
    FT_Outline_Translate(&face->glyph->outline, std::lround((p.x - whole) * 64), std::lround(p.y * 64));
    if (FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) != 0) continue;
    const FT_Bitmap& ink = face->glyph->bitmap;
    const int left = bitmap.left + static_cast<int>(whole) + face->glyph->bitmap_left;
    const int top = bitmap.base - face->glyph->bitmap_top;
    for (int row = 0; row < static_cast<int>(ink.rows); ++row)
      for (int column = 0; column < static_cast<int>(ink.width); ++column) {
        const int x = left + column;
        const int y = top + row;
        if (x < 0 || y < 0 || x >= bitmap.width || y >= bitmap.height) continue;
        auto& covered = bitmap.coverage[static_cast<std::size_t>(y * bitmap.width + x)];
        covered = std::max(covered, ink.buffer[row * ink.pitch + column]);
      }
  }
  return bitmap;
}

TextBitmap turned(const TextBitmap& bitmap) {
  TextBitmap result;
  result.width = bitmap.height;
  result.height = bitmap.width;
  result.left = bitmap.base;
  result.base = bitmap.width - 1 - bitmap.left;
  result.coverage.resize(bitmap.coverage.size());
  for (int y = 0; y < bitmap.height; ++y)
    for (int x = 0; x < bitmap.width; ++x)
      result.coverage[static_cast<std::size_t>((bitmap.width - 1 - x) * result.width + y)] =
          bitmap.coverage[static_cast<std::size_t>(y * bitmap.width + x)];
  return result;
}

}  // namespace plumb
