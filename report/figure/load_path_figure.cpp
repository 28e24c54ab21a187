#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "report/figure/ending_mark.h"
#include "report/figure/run_figures.h"

namespace plumb {
namespace {

/// The points of the path that are stable, or those that are not, with a gap where the others are and where
/// the cable went over to another equilibrium.
Series part(const std::vector<PathPoint>& path, bool stable) {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  Series series;
  series.label = stable ? "stable" : "unstable";
  series.color = palette[stable ? 0 : 1];
  if (!stable) series.dash = Dash::dashed;
  const auto add = [&](double displacement, double load) {
    series.x.push_back(displacement);
    series.y.push_back(load);
  };
  for (std::size_t k = 0; k < path.size(); ++k) {
    const bool is_mine = (path[k].negative == 0) == stable;
    const bool was_mine = k > 0 && (path[k - 1].negative == 0) == stable;
    if (k > 0 && !path[k].joined) add(gap, gap);
    // Both parts reach to the point between them.
    if (is_mine && k > 0 && !was_mine && path[k].joined) {
      add(gap, gap);
      add(path[k - 1].displacement, path[k - 1].load);
    }
    if (is_mine) add(path[k].displacement, path[k].load);
  }
  return series;
}

Series marks(const std::vector<CriticalPoint>& points, CriticalKind kind) {
  Series series;
  series.label = in_words(kind);
  series.line_width = 0;
  series.marker = kind == CriticalKind::limit_point ? Marker::square : Marker::circle;
  series.color = palette[kind == CriticalKind::limit_point ? 2 : 3];
  for (const CriticalPoint& point : points)
    if (point.kind == kind) {
      series.x.push_back(point.displacement);
      series.y.push_back(point.load);
    }
  return series;
}

}  // namespace

/// The load over the displacement along the path of equilibria of statics, its stable and unstable parts told
/// apart, with its critical points and the outputs.
std::optional<Figure> load_path_figure(const Run& run) {
  const Equilibria& equilibria = run.trajectory.equilibria;
  if (equilibria.path.empty()) return std::nullopt;
  Panel panel;
  panel.x.label = "greatest displacement of a node [m]";
  panel.y.label = "load [share of the whole]";
  for (Series& series : std::vector{part(equilibria.path, true), part(equilibria.path, false),
                                    marks(equilibria.critical_points, CriticalKind::limit_point),
                                    marks(equilibria.critical_points, CriticalKind::bifurcation)})
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  Figure figure;
  figure.title = title_of(run, "Load over displacement");
  figure.alt =
      fmt::format("Plot of the load over the greatest displacement of a node along a path of {} equilibria",
                  equilibria.path.size());
  for (const CriticalPoint& point : equilibria.critical_points)
    figure.alt += fmt::format("; a {} at {:.6g} of the load and {:.4g} m", in_words(point.kind), point.load,
                              point.displacement);
  figure.alt += ".";
  figure.plot.panels = {std::move(panel)};
  return figure;
}

}  // namespace plumb
