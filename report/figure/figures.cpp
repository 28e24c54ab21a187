#include "report/figure/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/known_time.h"
#include "render/gl/markup.h"
#include "report/figure/ending_mark.h"
#include "report/figure/number_markup.h"
#include "report/figure/round_off.h"
#include "report/figure/run_figures.h"

namespace plumb {
namespace {

constexpr double difference_share = 0.4;  // height of the lower panel against 1

// Half of a band, of the greatest difference: a narrower one could not be told from a line.
constexpr double least_seen = 0.02;

/// Values and unit of a column, or of time.
struct Data {
  const std::vector<double>& values;
  std::string unit;
};

/// The rows that figures are of: outputs, or modes in their place.
const ProbeTable& table_of(const Run& run) {
  return has_modes(run) ? run.modes : run.probes;
}

/// The name of what rows stand over.
std::string abscissa_of(const Run& run) {
  return std::string(word(has_modes(run) ? Abscissa::mode : Abscissa::time));
}

Data data_of(const Run& run, const std::string& column) {
  if (column == abscissa_of(run)) return {table_of(run).times, has_modes(run) ? "" : "s"};
  // A run that failed may have no modes.
  static const Column none{"", "1", {}};
  const Column* found = table_of(run).find(column);
  if (found == nullptr) found = &none;
  return {found->values, found->unit};
}

std::string label(const std::string& given, const std::string& column, const std::string& unit) {
  const std::string name = !given.empty() ? given : column == "t" ? "time" : literal(column);
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit_markup(unit));
}

Series line(const std::string& name, std::vector<double> x, std::vector<double> y) {
  Series series;
  series.label = name;
  series.x = std::move(x);
  series.y = std::move(y);
  return series;
}

const SeriesError* find_error(const Run& run, const std::vector<SeriesError>& errors, const FigureSpec& spec,
                              const std::string& column) {
  for (const SeriesError& error : errors)
    if (!error.given_run && !error.exact &&
        run.loaded.spec.references[error.reference].name == spec.reference && error.column == column)
      return &error;
  return nullptr;
}

Dash given_dash(std::size_t given_run) {
  return given_run % 2 == 0 ? Dash::dashed : Dash::dotted;
}

/// The palette's after those of the reported run and of the reference's points.
Color given_color(std::size_t given_run) {
  return palette[(given_run + 2) % palette.size()];
}

/// The external runs beside the one that is reported, over it in the same panel.
void add_given_runs(const Run& run, const FigureSpec& spec, Panel& panel) {
  const Case& the_case = run.loaded.spec;
  for (std::size_t k = reports_given_run(the_case) ? 1 : 0; k < the_case.given_runs.size(); ++k) {
    const GivenRun& given = run.loaded.given_runs[k];
    const GivenColumn *x = given.find(spec.x), *y = given.find(spec.y);
    if (y == nullptr || (x == nullptr && spec.x != "t")) continue;
    panel.series.push_back(
        line(literal(the_case.given_runs[k].name), x ? x->values : given.times, y->values));
    panel.series.back().dash = given_dash(k);
    panel.series.back().color = given_color(k);
  }
}

/// Their differences to the reference of the figure. Of several columns, colours tell the column, and dashes
/// the run.
void add_given_differences(const Run& run, const FigureSpec& spec, const std::vector<SeriesError>& errors,
                           const std::vector<const SeriesError*>& compared, Panel& panel) {
  const Case& the_case = run.loaded.spec;
  const bool several = compared.size() > 1;
  for (const SeriesError& error : errors) {
    const bool of_figure = error.given_run && !error.exact &&
                           the_case.references[error.reference].name == spec.reference &&
                           (error.column == spec.x || error.column == spec.y) && !error.times.empty();
    if (!of_figure) continue;
    panel.series.push_back(line(literal(given_name(error, the_case) + (several ? ": " + error.column : "")),
                                error.times, error.difference));
    panel.series.back().dash = given_dash(*error.given_run);
    panel.series.back().color = !several                                   ? given_color(*error.given_run)
                                : error.column == compared.front()->column ? palette[0]
                                                                           : palette[1];
  }
}

Series points(const std::string& name, std::vector<double> x, std::vector<double> y) {
  Series series = line(name, std::move(x), std::move(y));
  series.line_width = 0;
  series.marker = Marker::circle;
  return series;
}

const ReferenceSeries& reference_of(const Run& run, const SeriesError& error) {
  return *run.loaded.references[error.reference].find(error.series);
}

/// Rows of a reference within the time of the run: what is drawn of it, whether it can be compared or not.
std::vector<std::size_t> shown_rows(const Run& run, const SeriesError& error) {
  const std::vector<double>& times = run.loaded.references[error.reference].times;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < times.size(); ++row)
    if (known_time(table_of(run).times, times[row])) rows.push_back(row);
  return rows;
}

std::vector<double> at_rows(const std::vector<double>& all, const std::vector<std::size_t>& rows) {
  std::vector<double> some;
  for (const std::size_t row : rows) some.push_back(all[row]);
  return some;
}

Extent uncertainty_of(const Run& run, const SeriesError& error, const std::vector<double>& values) {
  const double half = reference_of(run, error).uncertainty;
  Extent extent;
  for (const double value : values) {
    extent.lower.push_back(value - half);
    extent.upper.push_back(value + half);
  }
  return extent;
}

/// How far off the reference itself may be, about the line of no difference: once for all that agree,
/// and where it can be seen.
void add_uncertainties(const Run& run, const std::vector<const SeriesError*>& errors, Panel& panel) {
  for (const SeriesError* error : errors) {
    const double half = reference_of(run, *error).uncertainty;
    if (!(half > least_seen * error->max)) continue;
    const bool known = std::any_of(panel.rules.begin(), panel.rules.end(),
                                   [&](const Rule& rule) { return rule.to == half; });
    if (known) continue;
    Rule band;
    band.from = -half;
    band.to = half;
    band.label =
        fmt::format("uncertainty of the reference: ±{} {}", number_markup(half), unit_markup(error->unit));
    panel.rules.push_back(std::move(band));
  }
}

/// Points in the place of lines, as between two modes there is nothing.
void mark_alone(Panel& panel) {
  for (Series& series : panel.series) {
    series.line_width = 0;
    series.marker = Marker::diamond;
  }
}

/// Of differences between values that are rounded: some units in the last place of the greatest.
double round_off_of(const Run& run, const std::vector<const SeriesError*>& errors) {
  constexpr double units = 8;
  double greatest = 0;
  for (const SeriesError* error : errors)
    for (const double value : reference_of(run, *error).values)
      if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
  return units * std::numeric_limits<double>::epsilon() * greatest;
}

Panel difference_panel(const Run& run, const std::vector<const SeriesError*>& errors) {
  const Case& spec = run.loaded.spec;
  const bool alone = spec.given_runs.empty() || (reports_given_run(spec) && spec.given_runs.size() == 1);
  Panel panel;
  panel.height_share = difference_share;
  panel.x.label = has_modes(run) ? "mode" : "time [s]";
  panel.y.label = fmt::format("{} − ref. [{}]", alone ? literal(reported_name(spec)) : "run",
                              unit_markup(errors.front()->unit));
  panel.y.zero_line = true;
  for (const SeriesError* error : errors)
    panel.series.push_back(line(literal(errors.size() > 1 ? error->column
                                        : alone           ? ""
                                                          : reported_name(spec)),
                                error->times, error->difference));
  if (has_modes(run)) mark_alone(panel);
  add_uncertainties(run, errors, panel);
  return panel;
}

std::string alt_text(const Case& the_case, const FigureSpec& spec,
                     const std::vector<const SeriesError*>& compared) {
  std::string text = fmt::format("Plot of {} over {}", spec.y, spec.x == "t" ? "time" : spec.x);
  if (!the_case.given_runs.empty()) {
    text += " by " + reported_name(the_case);
    for (std::size_t k = reports_given_run(the_case) ? 1 : 0; k < the_case.given_runs.size(); ++k)
      text += ", " + the_case.given_runs[k].name;
  }
  for (const SeriesError* error : compared)
    text += fmt::format("{} {}: greatest difference {:.3g} {} at {}{:.4g}{}",
                        error == compared.front() ? " with the reference's points under it." : ";",
                        error->column, error->max, error->unit, error->coverage.of_modes ? "mode " : "",
                        error->max_time, error->coverage.of_modes ? "" : " s");
  return text + ".";
}

Figure case_figure(const Run& run, const FigureSpec& spec, const std::vector<SeriesError>& errors) {
  const bool of_modes = has_modes(run), over_rows = spec.x == abscissa_of(run);
  const Data x = data_of(run, spec.x), y = data_of(run, spec.y);
  Panel panel;
  panel.x.label = label(spec.x_label, spec.x, x.unit);
  panel.y.label = label(spec.y_label, spec.y, y.unit);
  if (spec.x != abscissa_of(run)) panel.x.column = spec.x;
  panel.y.column = spec.y;
  panel.equal_axes = spec.equal_axes;
  panel.series.push_back(line(literal(reported_name(run.loaded.spec)), x.values, y.values));
  if (of_modes) mark_alone(panel);

  std::vector<const SeriesError*> compared;
  const SeriesError* of_y = find_error(run, errors, spec, spec.y);
  const SeriesError* of_x = find_error(run, errors, spec, spec.x);
  std::vector<double> shown_times;
  if (of_y && (of_x || over_rows)) {
    const Reference& reference = run.loaded.references[of_y->reference];
    const std::vector<std::size_t> rows = shown_rows(run, *of_y);
    shown_times = at_rows(reference.times, rows);
    const std::vector<double> ys = at_rows(reference_of(run, *of_y).values, rows);
    const std::vector<double> xs = of_x ? at_rows(reference_of(run, *of_x).values, rows) : shown_times;
    if (!rows.empty()) {
      panel.series.push_back(
          points(reference.kind == ReferenceKind::published ? "published" : "computed", xs, ys));
      panel.series.back().y_error = uncertainty_of(run, *of_y, ys);
      if (of_x) panel.series.back().x_error = uncertainty_of(run, *of_x, xs);
    }
    for (const SeriesError* error : {of_x, of_y})
      if (error != nullptr && !error->times.empty()) compared.push_back(error);
  }

  add_given_runs(run, spec, panel);

  Figure figure;
  if (!of_modes) figure.times.push_back({over_rows, {}});
  if (!over_rows && !of_modes) {
    figure.times.back().of_points.push_back(table_of(run).times);
    if (!shown_times.empty()) figure.times.back().of_points.push_back(shown_times);
  }
  figure.name = spec.name;
  figure.title = title_of(run, spec.title.empty() ? spec.name : spec.title);
  figure.alt = alt_text(run.loaded.spec, spec, compared);
  figure.plot.height = spec.equal_axes ? 1800 : 1200;
  panel.shares_x_below = over_rows && !compared.empty();
  if (over_rows && !of_modes) mark_ending(run, panel);
  figure.plot.panels.push_back(std::move(panel));
  if (!compared.empty()) {
    figure.plot.panels.push_back(difference_panel(run, compared));
    add_given_differences(run, spec, errors, compared, figure.plot.panels.back());
    mark_round_off(figure.plot.panels.back(), round_off_of(run, compared));
    if (!of_modes) {
      figure.times.push_back({true, {}});
      mark_ending(run, figure.plot.panels.back());
    }
  }
  return figure;
}

}  // namespace

std::vector<Figure> figures(const Run& run, const std::vector<SeriesError>& errors) {
  std::vector<Figure> result;
  for (const FigureSpec& spec : run.loaded.spec.figures) result.push_back(case_figure(run, spec, errors));
  // Of an external run neither energies nor fields are known.
  const std::span<const RunFigure> of_every_run =
      run.trajectory.energies.empty() ? std::span<const RunFigure>() : run_figures();
  for (const RunFigure& known : of_every_run) {
    // A case that was read before there was this figure may have taken its name.
    const bool taken = std::any_of(result.begin(), result.end(),
                                   [&](const Figure& figure) { return figure.name == known.name; });
    // Of modes there is nothing over time.
    const bool drawn = !taken && known.of_modes == has_modes(run);
    std::optional<Figure> figure = drawn ? known.draw(run) : std::nullopt;
    if (!figure) continue;
    figure->name = known.name;
    result.push_back(std::move(*figure));
  }
  for (Figure& figure : result) {
    figure.plot.title = literal(figure.title);
    figure.plot.theme = run.loaded.spec.scene.theme;
  }
  return result;
}

}  // namespace plumb
