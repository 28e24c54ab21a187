#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/read/case_sections.h"

namespace plumb {

CameraSpec read_camera(TableReader table) {
  CameraSpec camera;
  camera.eye = table.vector("eye", "m");
  camera.target = table.vector("target", "m");
  camera.up = table.vector("up", "", camera.up);
  camera.field_of_view =
      table.number("field_of_view", Range::between(1, 120, "degrees"), camera.field_of_view);
  if (const auto height = table.optional_number("view_height", Range::positive("m"))) {
    camera.view_height = *height;
    if (table.has("field_of_view"))
      table.refuse_value("view_height", "is for parallel rays, which have no field_of_view; give only one");
  }
  table.finish();

  const Vec3 view = camera.target - camera.eye;
  if (!(view.stableNorm() > 0) || !view.allFinite())
    table.refuse_value("target", "must be somewhere else than eye");
  if (!(camera.up.stableNorm() > 0)) table.refuse_value("up", "must not be zero");
  const double sine = view.stableNormalized().cross(camera.up.stableNormalized()).norm();
  if (!(sine > 1e-6)) table.refuse_value("up", "must not be parallel to the view, from eye to target");
  return camera;
}

SceneSpec read_scene(TableReader table, const TimeSpec& time) {
  constexpr double most_pixels = 1.5e8;
  constexpr double most_frames = 1e5;
  SceneSpec scene;
  table.read(scene);
  if (table.is_text("camera")) {
    scene.view = table.choice<View>("camera");
  } else if (table.has("camera")) {
    scene.camera = read_camera(table.table("camera"));
  }
  table.finish();
  if (scene.tolerance > std::max(scene.size[0], scene.size[1]))
    table.refuse_value("tolerance", fmt::format("must be at most as many pixels as the picture has, {}",
                                                std::max(scene.size[0], scene.size[1])));

  const double pixels = 1.0 * scene.size[0] * scene.size[1];
  if (pixels > most_pixels) {
    table.refuse_value("size",
                       fmt::format("is {:.3g} pixels; at most {:g} are allowed", pixels, most_pixels));
  }
  if (scene.frame_rate * time.end > most_frames) {
    table.refuse_value(
        "frame_rate",
        fmt::format("gives {:.3g} frames until the end time, {} s; at most {} are allowed; give a lower rate",
                    scene.frame_rate * time.end, time.end, most_frames));
  }
  return scene;
}

}  // namespace plumb
