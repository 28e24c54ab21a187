#pragma once

#include <string>
#include <vector>

#include "engine/run/run.h"
#include "render/plot/plot.h"
#include "report/verdict/series_error.h"

namespace plumb {

/// When the points of a panel are, which links a figure of a page to the animation.
struct PanelTimes {
  bool along_x = false;                        ///< x is the time
  std::vector<std::vector<double>> of_points;  ///< s, of each series where x is not the time
};

/// A plot with what a file and a page need to show it.
struct Figure {
  std::string name;  ///< of the file, without its ending
  std::string title;
  std::string alt;  ///< what the figure shows, for those who cannot see it
  Plot plot;
  std::vector<PanelTimes> times;  ///< one for each panel; none: of no time
};

/// The figures of the case, each with the reference's points and the difference where it names one, and the
/// energies over time.
std::vector<Figure> figures(const Run& run, const std::vector<SeriesError>& errors);

}  // namespace plumb
