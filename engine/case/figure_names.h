#pragma once

#include <array>
#include <string_view>

#include "engine/case/case.h"

namespace plumb {

inline constexpr std::string_view tension_range_figure_name = "tension_range";
inline constexpr std::string_view curvature_range_figure_name = "curvature_range";
inline constexpr std::string_view strain_map_figure_name = "strain_map";
inline constexpr std::string_view load_path_figure_name = "load_path";

/// Of the figures that every run has, which those of a case cannot be called.
inline constexpr std::array run_figure_names = {energy_figure_name, tension_range_figure_name,
                                                curvature_range_figure_name, strain_map_figure_name,
                                                load_path_figure_name};

}  // namespace plumb
