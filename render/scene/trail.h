#pragma once

#include <span>
#include <vector>

#include "render/scene/camera.h"

namespace plumb {

/// A ribbon in triangles: clip position and opacity, five numbers a vertex. The places run from the oldest to
/// the newest; towards the oldest the ribbon fades and narrows from `width` pixels. Places behind the camera
/// break it.
std::vector<float> trail_ribbon(std::span<const Vec3> places, const Camera& camera, double width,
                                int picture_width, int picture_height);

}  // namespace plumb
