#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// Where an axis is marked.
struct AxisTicks {
  std::vector<double> major;        ///< ascending, inside the range, whole multiples of `step`
  std::vector<double> minor;        ///< ascending, inside the range, without the major ones
  std::vector<std::string> labels;  ///< one a major tick, in units of 10^exponent, with a true minus sign
  double step = 0;                  ///< between major ticks: 1, 2 or 5 times a power of ten; 0: it grows
  int exponent = 0;                 ///< the power of ten taken out of all labels
};

/// What the labels of an axis have room for.
struct TickRoom {
  double length = 0;   ///< of the axis, pixels, > 0
  double spacing = 0;  ///< wished for between major ticks, pixels, > 0
  double gap = 0;      ///< at least left between two labels, pixels, ≥ 0
  /// A label's size along the axis, pixels.
  std::function<double(std::string_view)> extent;
};

/// Round ticks for the range from lo to hi, both finite, lo < hi by more than a billionth of their size: the
/// step of 1, 2 or 5 times a power of ten that comes closest to the wished spacing without labels that
/// overlap, with at least two ticks. Where even two labels have no room, those that would overlap are empty.
/// A power of ten is taken out when the largest tick is below 0.01 or from 100 000 on.
AxisTicks axis_ticks(double lo, double hi, const TickRoom& room);

/// The smallest of 1, 2 or 5 times a power of ten that is at least `wished` > 0.
double round_step(double wished);

/// The range of an axis for values from lo to hi, with a margin as a fraction of their span on either side.
/// Equal or hardly different values, and none (lo > hi), get a range around them that can be drawn.
struct AxisRange {
  double lo = 0;
  double hi = 1;
};
AxisRange fitted_range(double lo, double hi, double margin);

}  // namespace plumb
