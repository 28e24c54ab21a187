#pragma once

#include <string>
#include <vector>

#include "engine/run/output_folder.h"
#include "report/figure/pictures.h"
#include "report/study/sweep/sweep_results.h"

namespace plumb {

/// The shares of the outcomes, for all runs and for each method, as bars.
std::vector<Figure> sweep_figures(const Sweep& sweep);

/// Draws them into a folder: figures/*.png. Throws OutputError when drawing or writing fails, Interrupted
/// when the user stops it.
std::vector<Picture> draw_sweep(const Sweep& sweep, OutputFolder& folder);

/// The page of a sweep: one file that opens offline and needs no scripts.
std::string to_sweep_page(const SweepResults& results, const std::vector<Picture>& pictures);

}  // namespace plumb
