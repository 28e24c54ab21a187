#pragma once

#include "render/plot/axis_ticks.h"

namespace plumb {

/// Ends of a logarithmic axis stay between these, where powers of ten are normal numbers.
inline constexpr double least_log_end = 1e-300;
inline constexpr double greatest_log_end = 1e300;

/// Round ticks for a logarithmic axis from lo to hi, least_log_end ≤ lo < hi ≤ greatest_log_end, hi above lo
/// by more than a billionth. The ticks are
/// - powers of ten where two or more are inside: all of them, or every second, third, fifth… where there is
/// no
///   room for the labels of all; written "10^{−3}", or "0.01" to "1000" where all of them are in that range;
/// - else 1, 2 and 5 times a power of ten, where two or more of those are inside;
/// - else those of a linear axis.
/// Where even two labels have no room, those that would overlap are empty. `step` is 0, but for the last
/// kind.
AxisTicks log_axis_ticks(double lo, double hi, const TickRoom& room);

/// The range of a logarithmic axis for positive values from lo to hi, with a margin as a fraction of their
/// span in decades on either side. Equal or hardly different values get a range around them; none (lo > hi),
/// 1 to 10.
AxisRange fitted_log_range(double lo, double hi, double margin);

}  // namespace plumb
