#pragma once

#include "engine/study/uncertainty/uncertainty.h"
#include "report/figure/figures.h"

namespace plumb {

inline constexpr const char* uncertainty_figure_name = "uncertainty";

/// Comparison errors of series with `fewest_times_drawn` times or more, one panel each: E over a band of k u
/// to either side, which it leaves where the run and the reference can be told apart. Without panels where no
/// series has so many.
Figure uncertainty_figure(const Uncertainty& uncertainty);
inline constexpr std::size_t fewest_times_drawn = 8;

}  // namespace plumb
