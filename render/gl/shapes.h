#pragma once

#include <Eigen/Core>

namespace plumb {

/// A place in a picture, pixels from the top left corner, y downwards.
using Point = Eigen::Vector2d;

/// A rectangle in a picture, pixels, y downwards.
struct Rect {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  bool contains(const Point& p) const {
    return p.x() >= left && p.x() <= right && p.y() >= top && p.y() <= bottom;
  }
};

enum class Dash { solid, dashed, dotted };
enum class Marker {
  none,
  circle,
  square,
  diamond,
  triangle_up,
  triangle_down,
  triangle_right,
  cross,
  plus,
  circled_cross
};
enum class Align { left, center, right };

}  // namespace plumb
