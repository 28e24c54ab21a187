#include <fmt/format.h>

#include <algorithm>

#include "report/figure/ending_mark.h"
#include "report/figure/round_off.h"
#include "report/figure/run_figures.h"
#include "report/verdict/results.h"

namespace plumb {

namespace {

/// Of equilibria, with strain energy and load in `energies`.
Figure figure_of_equilibria(const Run& run, Panel energies) {
  energies.series.erase(energies.series.begin());
  energies.series[2].label = "potential of the load that acts";
  energies.series[3].label = "sum";
  energies.shares_x_below = false;
  mark_ending(run, energies);
  Figure figure;
  figure.title = title_of(run, "Strain energy and potential of the load over time");
  figure.alt =
      "Plot of axial and bending strain energy, of the potential energy of the load as far as it acts, and "
      "of "
      "their sum over time, which change by the work of the load that grows.";
  figure.plot.panels = {std::move(energies)};
  figure.times = {{true, {}}};
  return figure;
}

}  // namespace

std::optional<Figure> energy_figure(const Run& run) {
  const Trajectory& trajectory = run.trajectory;
  const auto part = [&](const std::string& name, auto value) {
    std::vector<double> values;
    for (const Energies& e : trajectory.energies) values.push_back(value(e));
    Series series;
    series.label = name;
    series.x = trajectory.times;
    series.y = std::move(values);
    return series;
  };
  Panel energies;
  energies.x.label = "time [s]";
  energies.y.label = "energy [J]";
  energies.shares_x_below = true;
  energies.series = {part("kinetic", [](const Energies& e) { return e.kinetic; }),
                     part("axial strain", [](const Energies& e) { return e.axial; }),
                     part("bending strain", [](const Energies& e) { return e.bending; }),
                     part("potential", [](const Energies& e) { return e.potential; })};
  const bool is_closed = std::all_of(trajectory.energies.begin(), trajectory.energies.end(),
                                     [](const Energies& e) { return e.work == 0 && e.dissipated == 0; });
  if (!is_closed)
    energies.series.push_back(
        part("dissipated - work", [](const Energies& e) { return e.dissipated - e.work; }));
  energies.series.push_back(part("total", [](const Energies& e) { return e.total(); }));
  energies.series.back().color = Color{};
  energies.series.back().dash = Dash::dashed;
  if (!has_energy_to_keep(trajectory)) return figure_of_equilibria(run, std::move(energies));
  const double first = trajectory.energies.empty() ? 0 : trajectory.energies.front().total();
  const double kinetic = trajectory.kinetic_scale();
  Panel drift;
  drift.x.label = "time [s]";
  drift.y.label = kinetic > 0 ? "drift / kinetic [1]" : "drift [J]";
  drift.y.zero_line = true;
  drift.height_share = 0.4;
  drift.series = {
      part("", [&](const Energies& e) { return (e.total() - first) / (kinetic > 0 ? kinetic : 1); })};
  mark_round_off(drift, trajectory.energy_round_off() / (kinetic > 0 ? kinetic : 1));

  Figure figure;
  figure.title = title_of(run, "Energy over time");
  figure.alt = fmt::format(
      "Plot of kinetic, axial, bending, potential and total energy over time. The total drifts by at most "
      "{:.3g} J.",
      trajectory.energy_drift());
  mark_ending(run, energies);
  mark_ending(run, drift);
  figure.plot.panels = {std::move(energies), std::move(drift)};
  figure.times = {{true, {}}, {true, {}}};
  return figure;
}

}  // namespace plumb
