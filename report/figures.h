#pragma once

#include <string>
#include <vector>

#include "engine/output/run.h"
#include "render/plot.h"
#include "report/series_error.h"

namespace plumb {

/// A plot with what a file and a page need to show it.
struct Figure {
  std::string name;  ///< of the file, without its ending
  std::string title;
  std::string alt;  ///< what the figure shows, for those who cannot see it
  Plot plot;
};

/// The figures of the case, each with the reference's points and the difference where it names one, and the
/// energies over time.
std::vector<Figure> figures(const Run& run, const std::vector<SeriesError>& errors);

}  // namespace plumb
