#pragma once

#include <vector>

#include "engine/study/work_precision/work_precision.h"
#include "report/figure/figures.h"

namespace plumb {

/// A picture with more cannot be read.
inline constexpr std::size_t most_drawn_curves = 10;

inline constexpr const char* time_work_figure_name = "work_precision_time";
inline constexpr const char* total_work_figure_name = "work_precision_total";
inline constexpr const char* order_figure_name = "observed_orders";
inline constexpr const char* mesh_figure_name = "mesh_convergence";

/// The figures of a study, as far as there is something to show: time-integration error against work on the
/// mesh of the case, total error against work over all meshes, error against step with the observed orders,
/// and the convergence of the mesh. The first three have the best curves only where there are too many to
/// tell apart.
std::vector<Figure> study_figures(const WorkPrecision& study);

/// How far down a reference can be trusted, in words: "certified: …" or "not certified: …".
std::string certificate_in_words(const CertifiedReference& reference);

}  // namespace plumb
