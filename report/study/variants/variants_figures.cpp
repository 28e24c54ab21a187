#include "report/study/variants/variants_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/figure/number_markup.h"
#include "report/study/variants/variants_results.h"

namespace plumb {
namespace {

constexpr Dash dashes[] = {Dash::solid, Dash::dashed, Dash::dotted};

Color color_of(std::size_t variant) {
  return palette[variant % palette.size()];
}

/// A line, with a cross at its end where the run ended before its time.
void add_line(std::size_t index, const VariantResult& variant, std::vector<double> x, std::vector<double> y,
              Panel& panel) {
  if (x.empty()) return;
  Series line;
  line.label = variant.spec.name;
  line.color = color_of(index);
  line.dash = dashes[(index / palette.size()) % std::size(dashes)];
  line.x = std::move(x);
  line.y = std::move(y);
  Series end;
  end.color = line.color;
  end.line_width = 0;
  end.marker = Marker::cross;
  end.marker_size = 1.3;
  end.x = {line.x.back()};
  end.y = {line.y.back()};
  panel.series.push_back(std::move(line));
  if (ended_early(variant)) panel.series.push_back(std::move(end));
}

/// Something to hold the change of the energy against in every variant.
bool has_scale(const Variants& study) {
  return std::all_of(study.variants.begin(), study.variants.end(), [](const VariantResult& variant) {
    return variant.trajectory.energies.empty() || variant.trajectory.kinetic_scale() > 0;
  });
}

std::vector<double> changes(const Trajectory& trajectory, bool relative) {
  std::vector<double> values;
  const double scale = relative && !trajectory.energies.empty() ? trajectory.kinetic_scale() : 1;
  for (const Energies& energies : trajectory.energies)
    values.push_back((energies.total() - trajectory.energies.front().total()) / scale);
  return values;
}

/// The legend stands above the panels, in two columns, and takes none of their height.
int height_for(const Variants& study) {
  constexpr int without_legend = 1150, legend_row = 45;
  return without_legend + legend_row * static_cast<int>((study.variants.size() + 1) / 2);
}

std::string ends_in_words(const Variants& study) {
  std::string text;
  for (const VariantResult& variant : study.variants) {
    if (!ended_early(variant)) continue;
    text += fmt::format("{}{} at {:.4g} s ({})", text.empty() ? " Ended early: " : ", ", variant.spec.name,
                        variant.trajectory.end_time, word(variant.trajectory.outcome));
  }
  return text.empty() ? " All ran to their end." : text + ".";
}

Figure energy_figure(const Variants& study) {
  const bool relative = has_scale(study);
  Panel change, size;
  change.y.label = relative ? "change / kinetic [1]" : "change of energy [J]";
  change.y.zero_line = true;
  change.shares_x_below = true;
  size.x.label = "time [s]";
  size.y.label = relative ? "|change| / kinetic [1]" : "|change| [J]";
  size.y.scale = Scale::logarithmic;
  size.legend = false;
  for (std::size_t k = 0; k < study.variants.size(); ++k) {
    const VariantResult& variant = study.variants[k];
    std::vector<double> values = changes(variant.trajectory, relative);
    add_line(k, variant, variant.trajectory.times, values, change);
    for (double& value : values) value = std::abs(value);
    add_line(k, variant, variant.trajectory.times, std::move(values), size);
  }
  Figure figure;
  figure.name = variants_energy_figure_name;
  figure.title = "Change of the total energy over time";
  figure.alt =
      "Plot of the change of the total energy over time, one line a variant, below it the size of the "
      "change on a logarithmic axis." +
      ends_in_words(study);
  figure.plot.title = figure.title;
  figure.plot.height = height_for(study);
  figure.plot.panels = {std::move(change)};
  const bool any_change = std::any_of(size.series.begin(), size.series.end(), [](const Series& series) {
    return std::any_of(series.y.begin(), series.y.end(), [](double y) { return y > 0 && std::isfinite(y); });
  });
  if (any_change) {
    figure.plot.panels.push_back(std::move(size));
  } else {
    figure.plot.panels.front().shares_x_below = false;
    figure.plot.panels.front().x.label = "time [s]";
  }
  return figure;
}

Figure probe_figure(const Variants& study) {
  Panel panel;
  panel.x.label = "time [s]";
  std::string name;
  for (std::size_t k = 0; k < study.variants.size(); ++k) {
    const VariantResult& variant = study.variants[k];
    if (variant.probes.columns.empty()) continue;
    const Column& column = variant.probes.columns.front();
    if (name.empty()) {
      name = column.name;
      panel.y.label = fmt::format("{} [{}]", name, unit_markup(column.unit));
    }
    add_line(k, variant, variant.probes.times, column.values, panel);
  }
  Figure figure;
  figure.name = variants_probe_figure_name;
  figure.title = fmt::format("{} over time", name);
  figure.alt = fmt::format("Plot of {} over time, one line a variant.", name) + ends_in_words(study);
  figure.plot.title = figure.title;
  figure.plot.height = height_for(study);
  if (!panel.series.empty()) figure.plot.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

std::vector<Figure> variants_figures(const Variants& study) {
  std::vector<Figure> figures;
  for (Figure& figure : std::vector<Figure>{energy_figure(study), probe_figure(study)})
    if (!figure.plot.panels.empty() && !figure.plot.panels.front().series.empty())
      figures.push_back(std::move(figure));
  return figures;
}

}  // namespace plumb
