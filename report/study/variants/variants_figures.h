#pragma once

#include <vector>

#include "engine/study/variants/variants.h"
#include "report/figure/figures.h"

namespace plumb {

inline constexpr const char* variants_energy_figure_name = "variants_energy";
inline constexpr const char* variants_probe_figure_name = "variants_probe";

/// The change of the energy over time, as it is and its size on a logarithmic axis, and the first column of
/// the probes over time, each of all variants over one another. A cross is where a run ended before its time.
std::vector<Figure> variants_figures(const Variants& study);

}  // namespace plumb
