#pragma once

#include <optional>
#include <span>

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/motion.h"
#include "render/stage.h"

namespace plumb {

/// The ground of a stage: grid lines that fade out, and the cable's soft shadow straight below it.
class Ground {
 public:
  /// `context`, `stage` and `camera` must outlive it. `cable_radius` and `length` in m; `line_width` of the
  /// grid in pixels of what the grid is drawn to.
  Ground(const GlContext& context, const Stage& stage, const Camera& camera, double cable_radius,
         double length, double line_width);

  /// Draws the grid to the framebuffer in use, in colours multiplied by their opacity.
  void draw_grid() const;
  /// Computes the shadow of a cable. Changes which framebuffer is in use.
  void cast_shadow(std::span<const CurvePoint> curve);
  /// Draws the shadow cast last to the framebuffer in use, the picture's own, of this height in pixels.
  void draw_shadow(int picture_height) const;

 private:
  const GlContext& context_;
  // Where in the picture a shadow can be whose edges are within these ground coordinates; nothing where that
  // cannot be told.
  std::optional<Rect> in_picture(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

  const Stage& stage_;
  const Camera& camera_;
  double cable_radius_;
  double shadow_reach_;  // half the side of the square that the shadow's map covers, m
  GlProgram grid_;
  GlProgram shadow_;
  GlProgram shadow_map_piece_;
  VertexBuffer pieces_;
  GlVertexArray no_attributes_;
  GlTexture shadow_map_;
  GlFramebuffer shadow_framebuffer_;
  std::optional<Rect> shadowed_;  // pixels
};

}  // namespace plumb
