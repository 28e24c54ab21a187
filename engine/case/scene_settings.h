#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

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
  std::array<int, 2> size{960, 540};  ///< pixels, 16 to 32768 each, at most 1.5e8 in all
  double frame_rate = 25;             ///< frames a second of simulated time, > 0; at most 100,000 frames
  int supersampling = 2;              ///< samples along each side of a pixel, 1 to 4
  double cable_radius = 0;            ///< as drawn, m; 0: the true radius, but at least L/150
  View view = View::fit;
  std::optional<CameraSpec> camera;  ///< in the place of `view`
  SceneTheme theme = SceneTheme::light;
  SceneBackground background = SceneBackground::scene;
  ColorField color_by = ColorField::none;
  int ghosts = 0;               ///< earlier times shown, faded, 0 to 50
  double ghost_interval = 0.1;  ///< between them, s, > 0
  /// Greatest distance on the picture between the drawn centre line and the true one, pixels, > 0; what a
  /// model is chosen by that costs no more than the scene needs.
  double tolerance = 0.5;
  std::optional<double> trail;  ///< how long the tip's trail is seen, s, ≥ 0; default: 32 frames

  friend bool operator==(const SceneSpec&, const SceneSpec&) = default;
};

}  // namespace plumb
