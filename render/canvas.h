#pragma once

#include <optional>

#include "render/color.h"
#include "render/gl_objects.h"
#include "render/image.h"

namespace plumb {

/// A picture being drawn, in two layers. Geometry is drawn first, with depth, `supersampling` times as large and with
/// 4 samples in each of its pixels; resolve() averages it down. Flat drawings and text follow at the picture's own
/// size, so that they stay crisp. A picture without geometry starts with begin_flat().
class Canvas {
 public:
  /// Width and height in pixels, supersampling in samples along each side of a pixel, all ≥ 1.
  /// Throws OutputError when that is more than the renderer can draw.
  Canvas(const GlContext& context, int width, int height, int supersampling = 1);

  /// Directs drawing to the large layer, cleared, with depth test and blending on.
  void begin_geometry(Color background);
  /// Averages the large layer into the picture and directs drawing there.
  void resolve();
  /// Directs drawing to the picture, cleared.
  void begin_flat(Color background);
  /// Directs drawing to the picture as it is, all of it.
  void bind_flat() const;
  /// The same without a change to clipping or blending.
  void bind_flat_framebuffer() const;

  /// The picture so far. Throws OutputError when OpenGL has recorded an error.
  Image read() const;

  int width() const { return width_; }
  int height() const { return height_; }
  int supersampling() const { return supersampling_; }

 private:
  struct Geometry {
    explicit Geometry(const GlContext& context, int width, int height);
    GlTexture color;
    GlTexture depth;
    GlFramebuffer framebuffer;
  };

  const GlContext& context_;
  int width_;
  int height_;
  int supersampling_;
  GlTexture color_;
  GlFramebuffer framebuffer_;
  std::optional<Geometry> geometry_;
  std::optional<GlProgram> resolver_;
  GlVertexArray no_attributes_;
};

}  // namespace plumb
