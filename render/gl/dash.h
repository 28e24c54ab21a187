#pragma once

#include <span>
#include <utility>
#include <vector>

#include "render/gl/shapes.h"

namespace plumb {

/// The pieces of a line to draw, each from point to point. Points that are not finite break it; dashes and
/// dots have lengths in proportion to the line's width and run on around corners. A lone point gives a piece
/// of no length.
std::vector<std::pair<Point, Point>> dash_segments(std::span<const Point> points, Dash dash, double width);

}  // namespace plumb
