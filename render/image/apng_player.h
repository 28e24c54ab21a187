#pragma once

#include "render/image/png_pixels.h"

namespace plumb {

/// Shows the frames of an animated PNG as they are seen, on what those before them leave.
class ApngPlayer {
 public:
  /// Both must outlive it.
  ApngPlayer(const PngFile& file, const std::string& name) : file_(file), name_(name) {}

  /// Frame k, which must be there and none before one that was shown. Throws as decode_frame().
  const PngPixels& show(std::size_t k);

 private:
  void draw(const PngFrame& frame);

  const PngFile& file_;
  const std::string& name_;
  std::size_t drawn_ = 0;           ///< frames
  const PngFrame* last_ = nullptr;  ///< of those drawn, with what becomes of it still to be done
  PngPixels shown_;                 ///< with opacities
  Image before_;                    ///< what was there before the last frame, where it is to be undone
};

/// True if a frame hides all that was there.
bool stands_alone(const PngFile& file, const PngFrame& frame);

}  // namespace plumb
