#pragma once

#include <array>
#include <optional>
#include <string>

#include "render/plot/plot.h"

namespace plumb {

/// A logarithmic axis; without a range it takes that of its data.
inline Axis log_axis(const std::string& label, std::optional<std::array<double, 2>> range = {}) {
  Axis axis;
  axis.label = label;
  axis.range = range;
  axis.scale = Scale::logarithmic;
  return axis;
}

/// What the legend shows of bars of one colour: a series of no points.
inline Series bar_key(const std::string& label, Color color) {
  Series series;
  series.label = label;
  series.color = color;
  series.line_width = 0;
  series.marker = Marker::square;
  series.open_marker = false;
  series.marker_size = 1.4;
  return series;
}

inline void add_point(Series& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

}  // namespace plumb
