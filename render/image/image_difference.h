#pragma once

#include "render/image/image.h"

namespace plumb {

/// When two pictures that need not be the same to the byte count as different. Chosen for thin lines: a few
/// pixels close together count, wherever they are, and a rim that is blended differently counts as well.
struct DifferenceTolerance {
  int channel = 8;        ///< levels by which a channel of a pixel may differ, 0 to 255
  double density = 0.01;  ///< share of the pixels in any window that may differ by more, 0 to 1
};

/// Pixels along a side of the window; a picture that is smaller is one window.
inline constexpr int difference_window = 16;

/// How two pictures differ, in pixels of the second. Only the sizes are known where they are not the same.
struct ImageDifference {
  bool same_size = false;
  long changed = 0;    ///< pixels that differ at all
  long beyond = 0;     ///< pixels with a channel that differs by more than is allowed
  int greatest = 0;    ///< levels, of any channel, on black or on white where they are not opaque
  double density = 0;  ///< greatest share of `beyond` in any window
  int x = 0, y = 0;    ///< upper left corner of that window

  bool identical() const { return same_size && changed == 0; }
  bool within(const DifferenceTolerance& tolerance) const {
    return same_size && density <= tolerance.density;
  }
};

/// Compares what is seen: a colour without opacity is none. Throws Interrupted, as the next does.
ImageDifference difference(const Image& a, const Image& b, const DifferenceTolerance& tolerance);

/// The second picture, faded, with what it has and the first has not in blue and what it lacks in red: of two
/// pixels, the one further from the commonest colour of the pictures has something. Both must be of one size.
Image difference_image(const Image& a, const Image& b, const DifferenceTolerance& tolerance);

}  // namespace plumb
