#include "report/study/uncertainty/uncertainty_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/figure/number_markup.h"

namespace plumb {
namespace {

constexpr Color band_color = Color::hex(0x8A93A3);

Panel panel_of(const SeriesUncertainty& series) {
  Panel panel;
  panel.title = fmt::format("{}: {}", series.reference, series.column);
  panel.x.label = "time [s]";
  panel.y.label = fmt::format("E [{}]", unit_markup(series.unit));
  panel.y.zero_line = true;
  Series band;
  band.label = fmt::format("± {:g} u{}", coverage_factor, series.whole() ? "" : ", at least");
  band.color = band_color;
  band.line_width = 0;
  band.x = series.times;
  band.y.assign(series.times.size(), 0);
  for (const double u : series.validation) {
    band.band.lower.push_back(-coverage_factor * u);
    band.band.upper.push_back(coverage_factor * u);
  }
  Series error;
  error.label = "run − reference";
  error.color = palette[0];
  error.x = series.times;
  error.y = series.error;
  panel.series = {std::move(band), std::move(error)};
  return panel;
}

}  // namespace

Figure uncertainty_figure(const Uncertainty& uncertainty) {
  Figure figure;
  figure.name = uncertainty_figure_name;
  figure.title = "Comparison error and its expanded uncertainty over time";
  figure.alt = "One panel a series: the run minus the reference over a band of twice the uncertainty.";
  for (const SeriesUncertainty& series : uncertainty.series) {
    if (series.times.size() < fewest_times_drawn) continue;
    figure.plot.panels.push_back(panel_of(series));
    figure.alt += fmt::format(" {}: {}.", figure.plot.panels.back().title, series.finding);
  }
  double end = 0;
  for (const Panel& panel : figure.plot.panels) end = std::max(end, panel.series.front().x.back());
  for (Panel& panel : figure.plot.panels) {
    panel.x.range = {0, end};
    panel.shares_x_below = &panel != &figure.plot.panels.back();
    panel.legend = &panel == &figure.plot.panels.front();
  }
  figure.plot.title = figure.title;
  return figure;
}

}  // namespace plumb
