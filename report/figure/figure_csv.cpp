#include "report/figure/figure_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>

#include "engine/base/csv.h"
#include "render/gl/markup.h"
#include "report/figure/curve_style.h"

namespace plumb {
namespace {

using Maybe = std::optional<double>;

/// A text as a reader of numbers wants it, without markup.
std::string name_cell(const std::string& label) {
  std::string plain;
  for (const TextRun& run : read_markup(label)) plain += run.text;
  return csv_cell(plain);
}

class PlotTable {
 public:
  explicit PlotTable(const Plot& plot) : categories_(plot.key.categories) {
    for (std::size_t p = 0; p < plot.panels.size(); ++p) add(plot.panels[p], p + 1);
  }
  std::string take() { return fmt::to_string(csv_); }

 private:
  void row(std::string_view kind, const std::string& series, Maybe x, Maybe y, Maybe x_to = {},
           Maybe y_to = {}, const std::string& value = "") {
    fmt::format_to(std::back_inserter(csv_), "{},{},{}", panel_, kind, series);
    for (const Maybe& number : {x, y, x_to, y_to}) {
      csv_.push_back(',');
      if (number) fmt::format_to(std::back_inserter(csv_), "{}", *number);
    }
    fmt::format_to(std::back_inserter(csv_), ",{}\n", value);
  }

  void add(const Panel& panel, std::size_t number) {
    panel_ = number;
    add_ticks(panel.x, true);
    add_ticks(panel.y, false);
    if (panel.heat_map) add(*panel.heat_map, panel);
    if (panel.cells) add(*panel.cells, panel);
    for (const Bar& bar : panel.bars) row("bar", "", bar.x[0], bar.y[0], bar.x[1], bar.y[1], css(bar.color));
    for (const Rule& rule : panel.rules) {
      const std::string label = name_cell(rule.label);
      if (rule.upright)
        row("rule", label, rule.from, {}, rule.to);
      else
        row("rule", label, {}, rule.from, {}, rule.to);
    }
    for (std::size_t s = 0; s < panel.series.size(); ++s)
      add(panel.series[s],
          panel.series[s].label.empty() ? fmt::format("#{}", s + 1) : name_cell(panel.series[s].label));
  }

  void add(const Series& series, const std::string& name) {
    for (std::size_t i = 0; i < series.x.size(); ++i) row("point", name, series.x[i], series.y[i]);
    for (std::size_t i = 0; i < series.band.lower.size(); ++i)
      row("band", name, series.x[i], series.band.lower[i], series.x[i], series.band.upper[i]);
    for (std::size_t i = 0; i < series.x_error.lower.size(); ++i)
      row("x_error", name, series.x_error.lower[i], series.y[i], series.x_error.upper[i], series.y[i]);
    for (std::size_t i = 0; i < series.y_error.lower.size(); ++i)
      row("y_error", name, series.x[i], series.y_error.lower[i], series.x[i], series.y_error.upper[i]);
  }

  template <typename Value>
  void add_grid(const std::vector<double>& x_edges, const std::vector<double>& y_edges, const Panel& panel,
                Value value) {
    const auto middle = [](const std::vector<double>& edges, std::size_t k, Scale scale) {
      return scale == Scale::linear ? edges[k] / 2 + edges[k + 1] / 2
                                    : std::sqrt(edges[k]) * std::sqrt(edges[k + 1]);
    };
    for (std::size_t r = 0; r + 1 < y_edges.size(); ++r)
      for (std::size_t c = 0; c + 1 < x_edges.size(); ++c)
        row("cell", "", middle(x_edges, c, panel.x.scale), middle(y_edges, r, panel.y.scale), {}, {},
            value(r * (x_edges.size() - 1) + c));
  }

  void add(const HeatMap& map, const Panel& panel) {
    add_grid(map.x_edges, map.y_edges, panel,
             [&](std::size_t k) { return fmt::format("{}", map.values[k]); });
  }

  void add(const CellGrid& grid, const Panel& panel) {
    add_grid(grid.x_edges, grid.y_edges, panel, [&](std::size_t k) {
      const int place = grid.categories[k];
      if (place < 0) return std::string("none");
      const CellCategory& category = categories_[static_cast<std::size_t>(place)];
      return name_cell(!category.label.empty()    ? category.label
                       : !category.letter.empty() ? category.letter
                                                  : fmt::format("#{}", place + 1));
    });
  }

  void add_ticks(const Axis& axis, bool x) {
    for (std::size_t k = 0; k < axis.tick_labels.size(); ++k)
      row("tick", "", x ? Maybe(axis.ticks[k]) : Maybe(), x ? Maybe() : Maybe(axis.ticks[k]), {}, {},
          name_cell(axis.tick_labels[k]));
  }

  const std::vector<CellCategory>& categories_;
  fmt::memory_buffer csv_;
  std::size_t panel_ = 0;
};

}  // namespace

std::string to_csv(const Plot& plot) {
  return "panel,kind,series,x,y,x_to,y_to,value\n" + PlotTable(plot).take();
}

}  // namespace plumb
