#pragma once

#include <functional>
#include <limits>
#include <string>

#include "render/image/png.h"
#include "render/scene/scene.h"

namespace plumb {

/// Frames of an animation, the first and the last included.
struct FrameRange {
  int first = 0;
  int last = 0;

  /// As `last`: to the end.
  static constexpr int open_end = std::numeric_limits<int>::max() - 1;

  int count() const { return last - first + 1; }
};

/// Takes frame k as a PNG file.
using TakeFrame = std::function<void(int k, std::string png)>;

/// Draws frames of a scene, which must have them, and hands them over in order. While one is drawn, those
/// before it are encoded on other threads, and `take` is called on this one. Throws what drawing or `take`
/// throws, and Interrupted when the user stops it.
void stream_frames(SceneRenderer& scene, const FrameRange& range, const PngTexts& texts, PngEffort effort,
                   const TakeFrame& take);

}  // namespace plumb
