#pragma once

#include <string>
#include <vector>

#include "engine/study/stability/stability.h"
#include "report/figure/figures.h"

namespace plumb {

/// The name of the figure with the maps of all methods over one axis; those of methods that control their
/// error are apart.
std::string map_figure_name(MapAxis axis, bool by_step);

inline constexpr const char* limits_figure_name = "stability_limits";
inline constexpr const char* energy_history_figure_name = "stability_energy";
inline constexpr const char* amplification_figure_name = "stability_amplification";
inline constexpr const char* separation_figure_name = "stability_separation";

/// The figures of a stability study, as far as there is something to show: maps of all methods over each
/// axis, critical steps beside the predicted ones, energies, amplification, and neighbours parting.
std::vector<Figure> stability_figures(const Stability& study);

/// One figure a method, with its maps below each other: "stability_rk4", ….
std::vector<Figure> method_figures(const Stability& study);

}  // namespace plumb
