#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "engine/case/key.h"

namespace plumb {

using Vec3 = Eigen::Vector3d;

/// A camera that is told where to stand.
struct CameraSpec {
  Vec3 eye{0, 0, 0};          ///< m
  Vec3 target{0, 0, 0};       ///< m
  Vec3 up{0, 1, 0};           ///< not along the view
  double field_of_view = 35;  ///< vertical, degrees, in [1, 120]
  double view_height = 0;     ///< m; > 0: parallel rays, this much of the scene from bottom to top

  friend bool operator==(const CameraSpec&, const CameraSpec&) = default;
};

/// Where a camera stands that finds its own place. Up is against gravity.
enum class View {
  fit,     ///< the whole run in view, from a little above
  front,   ///< parallel rays along an axis, fitted to the whole run: the axis of X to the right where it is
           ///< level
  back,    ///< from the other side
  left,    ///< from the left of `front`
  right,   ///< from the right of `front`
  top,     ///< down on the ground, with the right of `front` to the right
  bottom,  ///< from below
  orbit,   ///< once around the motion over the run, all of it in view
  follow,  ///< with the cable, which stays in the middle and as large as it is
};

enum class SceneTheme { light, dark };

/// What is behind the cable.
enum class SceneBackground {
  scene,        ///< ground with a grid, and a shade above it
  plain,        ///< one colour
  transparent,  ///< nothing: the picture has an alpha channel
};

/// What colours the cable along its length.
enum class ColorField { none, axial_strain, axial_force, curvature, bending_moment, speed };

struct SceneSpec {
  std::array<int, 2> size{960, 540};  ///< pixels, at most 1.5e8 in all
  double frame_rate = 25;             ///< frames a second of simulated time; at most 100,000 frames
  int supersampling = 2;              ///< samples along each side of a pixel
  double cable_radius = 0;            ///< as drawn, m; 0: the true radius, but at least L/150
  View view = View::fit;
  std::optional<CameraSpec> camera;  ///< in the place of `view`
  SceneTheme theme = SceneTheme::light;
  SceneBackground background = SceneBackground::scene;
  ColorField color_by = ColorField::none;
  int ghosts = 0;               ///< earlier times shown, faded
  double ghost_interval = 0.1;  ///< between them, s
  /// Greatest distance on the picture between the drawn centre line and the true one, pixels; what a model is
  /// chosen by that costs no more than the scene needs.
  double tolerance = 0.5;
  std::optional<double> trail;  ///< how long the tip's trail is seen, s; default: 32 frames

  friend bool operator==(const SceneSpec&, const SceneSpec&) = default;
};

/// All but the camera.
void visit_keys(SpecOf<SceneSpec> auto& scene, auto&& visit) {
  visit(Key{.name = "size", .range = Range::whole_between(16, 32768)}, scene.size);
  // The range of the delay between two frames in an animated PNG.
  visit(Key{.name = "frame_rate", .range = Range::between(0.02, 1000, "1/s")}, scene.frame_rate);
  visit(Key{.name = "supersampling", .range = Range::whole_between(1, 4)}, scene.supersampling);
  visit(Key{.name = "cable_radius", .range = Range::at_least(0, "m")}, scene.cable_radius);
  visit(Key{.name = "theme"}, scene.theme);
  visit(Key{.name = "background"}, scene.background);
  visit(Key{.name = "color_by"}, scene.color_by);
  visit(Key{.name = "ghosts", .range = Range::whole_between(0, 50)}, scene.ghosts);
  visit(Key{.name = "ghost_interval", .range = Range::positive("s")}, scene.ghost_interval);
  visit(Key{.name = "tolerance", .range = Range::positive("pixels")}, scene.tolerance);
  visit(Key{.name = "trail", .range = Range::at_least(0, "s")}, scene.trail);
}

}  // namespace plumb
