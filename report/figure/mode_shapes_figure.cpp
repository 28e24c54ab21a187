#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/model/cable.h"
#include "engine/run/mode_table.h"
#include "report/figure/ending_mark.h"
#include "report/figure/run_figures.h"

namespace plumb {
namespace {

constexpr int places = 200;
/// Curves in a panel that can still be told apart.
constexpr std::size_t most_curves = 6;

/// The displacements (m) at even places along the cable, for a greatest one of 1 m.
Eigen::Matrix3Xd displacements(const Cable& cable, const VibrationMode& mode) {
  const Eigen::VectorXd shape = displaced(mode, 1, 0);
  Eigen::Matrix3Xd result(3, places + 1);
  for (int k = 0; k <= places; ++k) result.col(k) = cable.interpolate(shape, static_cast<double>(k) / places);
  return result;
}

}  // namespace

/// The shapes of the first modes that are not rigid-body motions, in a panel for each axis along which some
/// of them move most.
std::optional<Figure> mode_shapes_figure(const Run& run) {
  constexpr std::array axes{"x", "y", "z"};
  const std::vector<VibrationMode>& modes = run.trajectory.vibrations.modes;
  const Cable cable(run.loaded.spec);
  std::array<Panel, 3> panels;
  Figure figure;
  figure.title = title_of(run, "Mode shapes");
  figure.alt = "Plot of the displacements of modes along the cable, each for a greatest one of 1:";
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const VibrationMode& mode = modes[k];
    if (mode.kind == ModeKind::rigid_body) continue;
    const Eigen::Matrix3Xd moved = displacements(cable, mode);
    Eigen::Index axis = 0;
    moved.cwiseAbs().rowwise().maxCoeff().maxCoeff(&axis);
    Panel& panel = panels[static_cast<std::size_t>(axis)];
    if (panel.series.size() == most_curves) continue;
    Series series;
    series.label = mode.frequency > 0 ? fmt::format("{}: {:.4g} Hz", k + 1, mode.frequency)
                                      : fmt::format("{}: {}", k + 1, word(mode.kind));
    series.color = palette[panel.series.size() % palette.size()];
    for (int at = 0; at <= places; ++at) {
      series.x.push_back(cable.length() * at / places);
      series.y.push_back(moved(axis, at));
    }
    panel.series.push_back(std::move(series));
    figure.alt += fmt::format(" mode {} along {};", k + 1, axes[static_cast<std::size_t>(axis)]);
  }
  for (const std::size_t axis : {std::size_t{1}, std::size_t{2}, std::size_t{0}}) {
    Panel& panel = panels[axis];
    if (panel.series.empty()) continue;
    panel.x.label = "distance along the cable [m]";
    panel.x.range = {0, cable.length()};
    panel.y.label = fmt::format("along {} [1]", axes[axis]);
    panel.y.zero_line = true;
    figure.plot.panels.push_back(std::move(panel));
  }
  if (figure.plot.panels.empty()) return std::nullopt;
  figure.alt.back() = '.';
  return figure;
}

}  // namespace plumb
