#pragma once

#include <span>

#include "render/gl/text.h"
#include "render/plot/plot_layout.h"

namespace plumb {

/// From where to where points go along an axis, pixels: what a logarithmic axis has no place for is at its
/// start, and what is not a number stays so.
struct ExtentPixels {
  std::vector<double> lower;
  std::vector<double> upper;
};
ExtentPixels pixels(const Extent& extent, const AxisMap& axis);

/// The area between the lower and upper ends at the places `x`, all in pixels, as coverage of the frame's
/// pixels; its top left corner is the frame's. A place or end that is not finite leaves a gap.
TextBitmap band_coverage(std::span<const double> x, const ExtentPixels& ends, const Rect& frame);

/// The strokes of error bars through the points, broken by points that are not finite: stems with caps of
/// half the given width. Those that reach no further than `hidden` from their point are left out.
std::vector<Point> error_bars(std::span<const Point> points, const ExtentPixels& ends, bool along_x,
                              double cap, double hidden);

}  // namespace plumb
