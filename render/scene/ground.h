#pragma once

#include <optional>
#include <span>

#include "render/gl/canvas.h"
#include "render/gl/gl_objects.h"
#include "render/scene/camera.h"
#include "render/scene/motion.h"
#include "render/scene/surroundings.h"

namespace plumb {

/// The ground of a surroundings: grid lines that fade out, and the cable's soft shadow straight below it.
class Ground {
 public:
  /// `context` and `surroundings` must outlive it. `cable_radius` and `length` in m; `line_width` of the grid
  /// in pixels of what the grid is drawn to; colours of the grid's lines and of the deepest shadow with their
  /// opacity.
  Ground(const GlContext& context, const Surroundings& surroundings, double cable_radius, double length,
         double line_width, Color grid, Color shadow);

  /// From where it is seen from now on. `camera` must live as long as it is.
  void look(const Camera& camera);
  /// Which part of the picture is drawn from now on: see the shaders.
  void set_tile(Color tile) const;
  /// False where it is seen edge on: there is nothing to draw then.
  bool is_seen() const;

  /// Draws the grid to the framebuffer in use, in colours multiplied by their opacity.
  void draw_grid() const;
  /// Computes the shadow of cables. Changes which framebuffer is in use.
  void cast_shadow(std::span<const std::vector<CurvePoint>> curves);
  /// Draws the shadow cast last to the canvas's picture, to which drawing is directed.
  void draw_shadow(const Canvas& canvas) const;

 private:
  const GlContext& context_;
  // Where in the picture a shadow can be whose edges are within these ground coordinates; nothing where that
  // cannot be told.
  std::optional<Rect> in_picture(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

  const Surroundings& surroundings_;
  const Camera* camera_ = nullptr;
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
