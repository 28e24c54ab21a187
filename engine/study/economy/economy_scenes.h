#pragma once

#include <string>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// What makes random scene k of a file's case, as --set takes it; it depends on the seed and k alone: the
/// parameter f (1 to 20, of equal ratio) if the case has it, the angular velocity (0 to 6 rad/s, about any
/// axis), the end (0.2 to 1 s), the width of the picture (160 to 1920 pixels, of equal ratio) and its shape,
/// the camera (one that finds its own place or one that is put somewhere), the rate of frames, and the
/// tolerance (0.25 to 4 pixels, of equal ratio).
std::vector<std::string> scene_overrides(const Case& file_case, long seed, long number);

}  // namespace plumb
