#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "render/gl/canvas.h"
#include "render/gl/shapes.h"
#include "render/gl/text.h"

namespace plumb {

/// Colours, sRGB and opacity, 0 to 255 each, rows from the top.
struct ColorBitmap {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Draws flat, anti-aliased shapes and text on a canvas. Lengths are in pixels from the top left corner, and
/// (0.5, 0.5) is the middle of the first pixel. A line is drawn into a mask first, where overlapping pieces
/// take the greater coverage: so joins are round, and neither they nor crossings darken a translucent line or
/// thicken an edge.
class Painter {
 public:
  explicit Painter(const GlContext& context);

  /// Starts drawing on `canvas`, which must outlive the drawing. Where it is a part of a larger picture,
  /// places are counted from that one's corner.
  void begin(const Canvas& canvas);

  /// Limits what follows to a rectangle, rounded to whole pixels.
  void clip(const Rect& rect);
  void clip_nothing();

  /// Through the points; those that are not finite break the line.
  void line(std::span<const Point> points, double width, Color color, Dash dash = Dash::solid);
  /// One marker at each finite point; `stroke` > 0 draws its outline only, of that width.
  void markers(std::span<const Point> points, Marker marker, double diameter, double stroke, Color color);
  /// Whole pixels only, so that its edges are crisp.
  void fill(const Rect& rect, Color color);
  /// Lines just inside a rectangle.
  void frame(const Rect& rect, int width, Color color);
  /// Its pixels as they are, from the corner at (left, top), rounded to whole pixels.
  void picture(const ColorBitmap& bitmap, double left, double top);
  /// One colour where a bitmap has coverage; (x, y) is where its pen starts.
  void stamp(const TextBitmap& bitmap, double x, double y, Color color);
  /// With its base line at `y`.
  void text(std::string_view text, TextStyle style, double x, double y, Align align, Color color);
  /// Turned by 90° against the clock, with its base line at `x`; `align` is along the text.
  void turned_text(std::string_view text, TextStyle style, double x, double y, Align align, Color color);

  const Font& font() const { return font_; }

 private:
  void draw_shapes(std::span<const float> shapes, Color color);
  void size_mask();
  void limit_to(const Rect& rect);

  const GlContext& context_;
  const Canvas* canvas_ = nullptr;
  std::optional<Rect> clip_;
  Font font_;
  GlProgram shapes_;
  GlProgram coverage_;
  GlProgram text_;
  VertexBuffer instances_;
  GlVertexArray no_attributes_;
  GlTexture mask_;
  GlFramebuffer mask_framebuffer_;
  GlTexture glyphs_;
  int mask_width_ = 0;
  int mask_height_ = 0;
};

}  // namespace plumb
