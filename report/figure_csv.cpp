#include "report/figure_csv.h"

#include <fmt/format.h>

#include "engine/input/csv.h"

namespace plumb {

std::string to_csv(const Plot& plot) {
  std::string csv = "panel,series,x,y\n";
  for (std::size_t p = 0; p < plot.panels.size(); ++p)
    for (std::size_t s = 0; s < plot.panels[p].series.size(); ++s) {
      const Series& series = plot.panels[p].series[s];
      const std::string label = csv_cell(series.label.empty() ? fmt::format("#{}", s + 1) : series.label);
      for (std::size_t i = 0; i < series.x.size(); ++i)
        csv += fmt::format("{},{},{:.17g},{:.17g}\n", p + 1, label, series.x[i], series.y[i]);
    }
  return csv;
}

}  // namespace plumb
