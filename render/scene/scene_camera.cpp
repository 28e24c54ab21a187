#include "render/scene/scene_camera.h"

#include <algorithm>
#include <cmath>

#include "render/scene/frame_texts.h"

namespace plumb {

namespace {

constexpr double thinnest = 1.0 / 150;  // radius as drawn, in cable lengths

}  // namespace

double drawn_radius(const SceneSpec& spec, double length, double radius) {
  return spec.cable_radius > 0 ? spec.cable_radius : std::max(radius, thinnest * length);
}

SceneCamera::SceneCamera(const Trajectory& run, const SceneInput& input)
    : motion_(run),
      radius_(drawn_radius(input.spec, input.length, input.radius)),
      width_(input.spec.size[0]),
      height_(input.spec.size[1]),
      frame_rate_(input.spec.frame_rate),
      surroundings_(make_surroundings(covered_places(motion_), input.length, radius_, input.gravity)) {
  FrameTexts texts;
  if (input.spec.color_by != ColorField::none) texts.bar = ColorBar{};
  path_.emplace(input.spec, surroundings_, motion_, radius_, static_cast<double>(width_) / height_,
                margins_beside(texts, width_, height_));
}

Camera SceneCamera::at(double time) const {
  return {path_->at(time), width_, height_, surroundings_.center, surroundings_.radius};
}

std::vector<double> SceneCamera::frame_times() const {
  const int frames = frame_count(motion_.end(), frame_rate_);
  std::vector<double> times;
  for (int k = 0; k < frames; ++k) times.push_back(std::min(k / frame_rate_, motion_.end()));
  return times;
}

}  // namespace plumb
