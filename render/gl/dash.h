#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "render/gl/shapes.h"

namespace plumb {

/// Lengths of what is on and off in turn, of a line of that width; round ends lengthen what is on by one
/// width and shorten what is off. Of a solid line nothing is off.
std::array<double, 2> dash_pattern(Dash dash, double width);

/// The pieces of a line to draw, each from point to point. Points that are not finite break it; dashes and
/// dots have lengths in proportion to the line's width and run on around corners. A lone point gives a piece
/// of no length.
std::vector<std::pair<Point, Point>> dash_segments(std::span<const Point> points, Dash dash, double width);

}  // namespace plumb
