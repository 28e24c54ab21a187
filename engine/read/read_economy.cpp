#include <fmt/format.h>

#include <algorithm>

#include "engine/read/case_sections.h"

namespace plumb {
namespace {

constexpr int smallest_side = 16, largest_side = 32768;

}  // namespace

EconomySpec default_economy(const SceneSpec& scene) {
  return {.widths = {scene.size[0]}, .close_up = {}, .scenes = 0, .seed = 1, .reference_elements = 64};
}

EconomySpec read_economy(TableReader table, const SceneSpec& scene) {
  constexpr double most_pixels = 1.5e8;
  EconomySpec spec = default_economy(scene);
  if (const auto widths = table.wholes("widths", smallest_side, largest_side)) {
    spec.widths = *widths;
    std::sort(spec.widths.begin(), spec.widths.end());
    spec.widths.erase(std::unique(spec.widths.begin(), spec.widths.end()), spec.widths.end());
  }
  if (table.has("close_up")) spec.close_up = read_camera(table.table("close_up"));
  table.read(spec);
  table.finish();
  for (const int width : spec.widths) {
    const double height = 1.0 * width * scene.size[1] / scene.size[0];
    if (height < smallest_side || height > largest_side || height * width > most_pixels)
      table.refuse_value(
          "widths", fmt::format("gives a picture of {} by {:.0f} pixels; each side must be from {} to {}, "
                                "and all of it at most {:g}",
                                width, height, smallest_side, largest_side, most_pixels));
  }
  return spec;
}

}  // namespace plumb
