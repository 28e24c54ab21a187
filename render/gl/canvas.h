#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/shapes.h"
#include "render/image/color.h"
#include "render/image/image.h"

namespace plumb {

/// A picture being drawn, in two layers: flat drawings and text at the picture's own size, so that they stay
/// crisp, and geometry, with depth, of `supersampling` by `supersampling` samples a pixel, which resolve()
/// averages and lays over the picture.
class Canvas {
 public:
  /// Width and height in pixels, supersampling in samples along each side of a pixel, all ≥ 1.
  /// Throws OutputError when that is more than the renderer can draw.
  Canvas(const GlContext& context, int width, int height, int supersampling = 1);

  /// Makes the canvas the part of a larger picture that starts at this pixel of it: places in the picture are
  /// then counted from the larger one's corner.
  void place_at(int left, int top);
  int left() const { return left_; }
  int top() const { return top_; }

  /// Directs drawing to the geometry layer, cleared to nothing, with depth test on. Colours drawn there are
  /// multiplied by their opacity. Geometry outside `region` (pixels of the picture) need not be drawn, which
  /// saves time. False where nothing of the region is on the canvas; then there is nothing to draw or
  /// resolve.
  bool begin_geometry(const Rect& region);
  /// Lays the geometry over the picture, as a whole as opaque as this, and directs drawing there.
  void resolve(double opacity = 1);
  /// Directs drawing to the picture, cleared; what is drawn on a background that is not opaque leaves a
  /// picture with opacities.
  void begin_flat(Color background);
  /// Directs drawing to the picture as it is, all of it.
  void bind_flat() const;
  /// The same without a change to clipping or blending.
  void bind_flat_framebuffer() const;

  /// Keeps the picture so far; restore() makes it the picture again.
  void keep();
  void restore() const;
  /// The picture so far. Throws OutputError when OpenGL has recorded an error.
  Image read() const;
  /// The same into its place in the larger picture, whose size and kind are set.
  void read_into(Image& picture) const;

  Rect whole() const { return {1.0 * left_, 1.0 * top_, 1.0 * left_ + width_, 1.0 * top_ + height_}; }
  int width() const { return width_; }
  int height() const { return height_; }
  /// How many times the geometry layer is as large along each side. Four samples of a pixel are one pixel of
  /// the layer, which costs a quarter of four pixels: an even supersampling has half as large a layer.
  int layer_scale() const { return layer_scale_; }

 private:
  struct Geometry {
    Geometry(const GlContext& context, int width, int height, int samples);
    GlTexture color;
    GlTexture depth;
    GlFramebuffer framebuffer;
  };

  // A picture of the canvas's size.
  struct Layer {
    Layer(const GlContext& context, int width, int height);
    GlTexture color;
    GlFramebuffer framebuffer;
  };

  void copy(const Layer& from, const Layer& to) const;
  // Limits drawing to the region, in a layer `scale` times the picture's size.
  void clip(int scale) const;

  const GlContext& context_;
  int width_;
  int height_;
  int samples_;  // a pixel of the geometry layer
  int layer_scale_;
  int left_ = 0;
  int top_ = 0;
  bool opaque_ = true;
  Layer flat_;
  std::optional<Layer> kept_;
  std::optional<Geometry> geometry_;
  Rect region_;
  std::optional<GlProgram> resolver_;
  GlVertexArray no_attributes_;
  mutable std::vector<std::uint8_t> rgba_;  // as it is read, kept from picture to picture
};

}  // namespace plumb
