#include "report/study/work_precision/work_precision_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/study/work_precision/pareto.h"
#include "report/figure/curve_style.h"
#include "report/figure/number_markup.h"
#include "report/study/panel_parts.h"
#include "report/study/work_precision/compared_lines.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

constexpr Color front_color = Color::hex(0xF0D98C);
constexpr Color trouble_color = Color::hex(0x555555);

struct Span {
  double lo = std::numeric_limits<double>::infinity();
  double hi = 0;

  void add(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  bool empty() const { return !(hi > 0); }
};

Series styled(const std::string& label, const CurveStyle& style) {
  Series series;
  series.label = label;
  series.color = style.color;
  series.marker = style.marker;
  series.open_marker = style.open_marker;
  series.dash = style.dash;
  return series;
}

/// A picture of error against work under construction.
class WorkFigure {
 public:
  WorkFigure(const WorkPrecision& study, StudyQuestion question)
      : study_(study), question_(question), styles_(curve_styles(study)) {}

  Figure make() {
    all_ = study_lines(study_, question_);
    lines_ = chosen_lines(study_, question_, most_drawn_curves);
    find_ranges();
    Panel panel;
    panel.x = log_axis(study_.work_axis(), x_range_);
    panel.y = log_axis(question_ == StudyQuestion::time ? "error of time integration: tip, greatest [m]"
                                                        : "total error: tip, greatest [m]",
                       y_range_);
    add_rules(panel);
    add_front(panel);
    for (const StudyLine& line : lines_) add_line(panel, line);
    for (std::size_t k = 0; k < study_.given_curves.size(); ++k) add_given(panel, k);
    add_trouble(panel);

    Figure figure;
    figure.name = question_ == StudyQuestion::time ? time_work_figure_name : total_work_figure_name;
    figure.title = question_ == StudyQuestion::time
                       ? fmt::format("Error of time integration against work, mesh of {}",
                                     counted(study_.fixed_elements, "element", "elements"))
                       : "Total error against work, all meshes";
    figure.alt = alt_text();
    figure.plot.title = figure.title;
    figure.plot.width = 2000;
    figure.plot.height = 1600;
    figure.plot.panels.push_back(std::move(panel));
    return figure;
  }

 private:
  double error(std::size_t run) const { return errors_of(study_.runs[run], question_).tip_max; }
  double work(std::size_t run) const { return study_.work(study_.runs[run]); }
  RunFate fate(std::size_t run) const { return fate_of(study_, study_.runs[run], question_); }

  void find_ranges() {
    Span x, y;
    for (const StudyLine& line : lines_)
      for (const std::size_t k : line.runs) {
        if (fate(k) == RunFate::failed) continue;
        x.add(work(k));
        y.add(error(k));
      }
    for (const GivenCurve& curve : study_.given_curves)
      for (const GivenPoint& point : curve.points) {
        if (fate_of(study_, point, question_) == RunFate::failed) continue;
        x.add(study_.work(curve, point));
        y.add(errors_of(point, question_).tip_max);
      }
    if (x.empty()) {
      x.add(1e-3);
      x.add(1);
    }
    if (y.empty()) {
      y.add(1e-6);
      y.add(0.1);
    }
    const CertifiedReference* reference = reference_of(study_, question_);
    double lo = y.lo / 2;
    // A floor far below shows nothing but empty paper.
    if (reference && reference->floor > lo / 30) lo = std::min(lo, reference->floor / 3);
    const double decades = std::log10(3 * y.hi / lo);
    y_range_ = {lo, y.hi * std::pow(10.0, std::max(0.4, 0.08 * decades))};
    x_range_ = {x.lo / 1.4, x.hi * 1.4};
    top_ = y_range_[1] / std::pow(y_range_[1] / y_range_[0], 0.025);
  }

  void add_rules(Panel& panel) const {
    if (const CertifiedReference* reference = reference_of(study_, question_);
        reference && reference->floor > 0) {
      Rule floor;
      floor.to = reference->floor;
      floor.label = fmt::format("{} m: {}", number_markup(reference->floor),
                                reference->certified ? "floor of the reference, below every error here"
                                                     : "floor of the reference, not certified below");
      panel.rules.push_back(floor);
    }
    if (question_ != StudyQuestion::total || !study_.mesh) return;
    for (std::size_t k = 0; k + 1 < study_.mesh->elements.size() && k < study_.mesh->distance.size(); ++k) {
      Rule mesh;
      mesh.from = mesh.to = study_.mesh->distance[k];
      mesh.label = fmt::format("{}, exact in time", counted(study_.mesh->elements[k], "element", "elements"));
      mesh.dash = Dash::dotted;
      panel.rules.push_back(mesh);
    }
  }

  void add_front(Panel& panel) const {
    Series front;
    for (const std::size_t k : front_of(study_, question_))
      if (fate(k) == RunFate::good && work(k) > 0) add_point(front, work(k), error(k));
    if (front.x.empty()) return;
    front.label = "Pareto front";
    front.color = front_color;
    front.line_width = 3.5;
    panel.series.push_back(std::move(front));
  }

  void add_line(Panel& panel, const StudyLine& line) const {
    const CurveStyle& style = styles_.at(line.label);
    Series series = styled(line.label, style);
    Series others = styled("", style);
    others.line_width = 0;
    others.marker_size = 0.55;
    others.color->a = 0.45F;
    std::vector<WorkError> points;
    for (const std::size_t k : line.runs)
      points.push_back(fate(k) == RunFate::good ? WorkError{work(k), error(k)} : WorkError{});
    if (question_ == StudyQuestion::time) {
      // What is not good has no place on the axes, and breaks the line.
      for (const WorkError& point : points) add_point(series, point.work, point.error);
    } else {
      // Over several meshes, a method is as good as its own front; what lies behind stays as small points.
      const std::vector<std::size_t> best = pareto_front(points);
      for (const std::size_t i : best) add_point(series, points[i].work, points[i].error);
      for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].error > 0 && std::find(best.begin(), best.end(), i) == best.end())
          add_point(others, points[i].work, points[i].error);
    }
    if (!others.x.empty()) panel.series.push_back(std::move(others));
    panel.series.push_back(std::move(series));
  }

  /// The curve of another program; what is not good of it has no place on the axes, and breaks the line.
  void add_given(Panel& panel, std::size_t k) const {
    const GivenCurve& curve = study_.given_curves[k];
    Series series = styled(label_of(study_, curve), given_style(study_, k));
    series.marker_size = 1.2;
    for (const GivenPoint& point : curve.points)
      if (fate_of(study_, point, question_) == RunFate::good && study_.work(curve, point) > 0)
        add_point(series, study_.work(curve, point), errors_of(point, question_).tip_max);
      else
        add_point(series, -1, -1);
    if (study_.timed) panel.series.push_back(std::move(series));
  }

  /// Runs that are wrong, at their error, and those whose error is not known, at the upper edge, where they
  /// ended or at the end of the axis.
  void add_trouble(Panel& panel) const {
    bool any_wrong = false, any_failed = false;
    // `each` is called with what takes a run's work, error and fate.
    const auto mark = [&](const CurveStyle& style, const auto& each) {
      Series wrong = styled("", style);
      wrong.line_width = 0;
      wrong.marker = Marker::circled_cross;
      wrong.marker_size = 1.15;
      Series failed = wrong;
      failed.marker = Marker::cross;
      failed.marker_size = 1.3;
      each([&](double cost, double off, RunFate of_run) {
        if (of_run == RunFate::wrong) add_point(wrong, cost, off);
        if (of_run == RunFate::failed)
          add_point(failed, std::clamp(cost, x_range_[0] * 1.1, x_range_[1] / 1.1), top_);
      });
      any_wrong = any_wrong || !wrong.x.empty();
      any_failed = any_failed || !failed.x.empty();
      if (!wrong.x.empty()) panel.series.push_back(std::move(wrong));
      if (!failed.x.empty()) panel.series.push_back(std::move(failed));
    };
    for (const StudyLine& line : lines_)
      mark(styles_.at(line.label), [&](const auto& take) {
        for (const std::size_t k : line.runs) take(work(k), error(k), fate(k));
      });
    for (std::size_t k = 0; study_.timed && k < study_.given_curves.size(); ++k)
      mark(given_style(study_, k), [&](const auto& take) {
        const GivenCurve& curve = study_.given_curves[k];
        for (const GivenPoint& point : curve.points)
          take(study_.work(curve, point), errors_of(point, question_).tip_max,
               fate_of(study_, point, question_));
      });
    const auto explain = [&](Marker marker, const std::string& text) {
      Series series;
      series.label = text;
      series.line_width = 0;
      series.marker = marker;
      series.marker_size = 1.2;
      series.color = trouble_color;
      panel.series.push_back(std::move(series));
    };
    if (any_wrong)
      explain(Marker::circled_cross,
              fmt::format("stable, but > {:g} % of the length off", 100 * wrong_beyond));
    if (any_failed) explain(Marker::cross, "failed (edge: error unknown)");
  }

  std::string alt_text() const {
    std::size_t wrong = 0, failed = 0, good = 0;
    for (const StudyLine& line : all_)
      for (const std::size_t k : line.runs) {
        wrong += fate(k) == RunFate::wrong;
        failed += fate(k) == RunFate::failed;
        good += fate(k) == RunFate::good;
      }
    std::string text = fmt::format(
        "Plot on logarithmic axes of the {} error of the tip in metres against the {}, "
        "for {} of {}: {} good, {} wrong, {} failed.",
        question_ == StudyQuestion::time ? "time-integration" : "total",
        study_.timed ? "seconds of the time loop" : "number of force evaluations", lines_.size(),
        counted(static_cast<long>(all_.size()), "method", "methods"),
        counted(static_cast<long>(good), "run", "runs"), wrong, failed);
    const auto& cheapest = question_ == StudyQuestion::time ? study_.time_cheapest : study_.total_cheapest;
    if (!cheapest.empty()) text += " The cheapest " + cheapest.front().in_words;
    if (cheapest.size() > 1) text += ", and " + cheapest.back().in_words;
    if (!cheapest.empty()) text += ".";
    for (const GivenCurve& curve : study_.given_curves)
      text += fmt::format(" Beside them {} of {}.", counted(std::ssize(curve.points), "run", "runs"),
                          label_of(study_, curve));
    if (const CertifiedReference* reference = reference_of(study_, question_))
      text += " The reference is " + certificate_in_words(*reference) + ".";
    return text;
  }

  const WorkPrecision& study_;
  StudyQuestion question_;
  std::map<std::string, CurveStyle> styles_;
  std::vector<StudyLine> all_;
  std::vector<StudyLine> lines_;
  std::array<double, 2> x_range_{};
  std::array<double, 2> y_range_{};
  double top_ = 0;
};

std::string order_in_words(const MethodCurve& curve) {
  if (curve.observed.order < 0) return "no order seen";
  return fmt::format("{:.2f} ± {:.2f}", curve.observed.order, curve.observed.deviation);
}

/// Mean step of a run, s; 0: not known.
double mean_step(const WorkPrecision& study, const WorkPrecisionRun& run) {
  return run.counters.steps > 0 ? study.end / static_cast<double>(run.counters.steps) : 0;
}

Figure order_figure(const WorkPrecision& study) {
  const auto styles = curve_styles(study);
  const std::vector<StudyLine> lines = chosen_lines(study, StudyQuestion::time, most_drawn_curves);
  Panel panel;
  panel.x = log_axis("mean step [s]");
  panel.y = log_axis("error of time integration: tip, greatest [m]");
  std::string seen;
  for (const StudyLine& line : lines) {
    const MethodCurve& curve = study.curves[line.curves.front()];
    const CurveStyle& style = styles.at(line.label);
    Series part = styled("", style);
    part.marker = Marker::none;
    part.dash = Dash::solid;
    part.line_width = 3.5;
    part.color->a = 0.3F;
    Series series = styled(
        curve.observed.order < 0 ? line.label : fmt::format("{}: {:.2f}", line.label, curve.observed.order),
        style);
    for (const std::size_t k : line.runs) {
      const WorkPrecisionRun& run = study.runs[k];
      if (fate_of(study, run, StudyQuestion::time) == RunFate::failed) continue;
      const double step = mean_step(study, run);
      add_point(series, step, run.time_error.tip_max);
      if (curve.observed.order >= 0 && step <= curve.observed.largest_step * (1 + 1e-9) &&
          step >= curve.observed.smallest_step * (1 - 1e-9))
        add_point(part, step, run.time_error.tip_max);
    }
    if (curve.observed.order >= 0)
      seen += fmt::format("{} {} {} (stated: {})", seen.empty() ? "" : ";", line.label, order_in_words(curve),
                          curve.stated_order);
    if (!part.x.empty()) panel.series.push_back(std::move(part));
    panel.series.push_back(std::move(series));
  }
  if (const CertifiedReference* reference = reference_of(study, StudyQuestion::time);
      reference && reference->floor > 0) {
    Rule floor;
    floor.to = reference->floor;
    floor.label = fmt::format("{} m: floor of the reference", number_markup(reference->floor));
    panel.rules.push_back(floor);
  }
  Figure figure;
  figure.name = order_figure_name;
  figure.title = "Error against step, with the orders observed";
  figure.alt = fmt::format(
      "Plot on logarithmic axes of the time-integration error of the tip in metres against the mean step in "
      "seconds, "
      "the parts that the orders were fitted to drawn wide. {}",
      seen.empty() ? "No order could be observed." : "Observed orders:" + seen + ".");
  figure.plot.title = figure.title;
  figure.plot.width = 2000;
  figure.plot.height = 1600;
  figure.plot.panels.push_back(std::move(panel));
  return figure;
}

Figure mesh_figure(const MeshConvergence& mesh) {
  Panel panel;
  panel.x = log_axis("elements");
  panel.x.ticks.assign(mesh.elements.begin(), mesh.elements.end());
  panel.y = log_axis("greatest distance of the tip [m]");
  Series distance;
  distance.label = fmt::format("to {} elements", mesh.elements.back());
  distance.marker = Marker::circle;
  distance.open_marker = false;
  for (std::size_t k = 0; k + 1 < mesh.elements.size() && k < mesh.distance.size(); ++k)
    add_point(distance, mesh.elements[k], mesh.distance[k]);
  Series change;
  change.label = "to the next finer mesh";
  change.marker = Marker::square;
  change.dash = Dash::dashed;
  for (std::size_t k = 0; k < mesh.change.size() && k < mesh.elements.size(); ++k)
    add_point(change, mesh.elements[k], mesh.change[k]);
  panel.series = {std::move(distance), std::move(change)};
  std::string text = fmt::format(
      "Plot on logarithmic axes of how far the tip is from that of finer meshes, against the number of "
      "elements, from {} "
      "to {}, each integrated exactly.",
      mesh.elements.front(), mesh.elements.back());
  const double finest = mesh.elements.back();
  const auto estimate = [&](double value, Marker marker, const std::string& label) {
    if (!(value > 0)) return;
    Series point;
    point.label = label;
    point.line_width = 0;
    point.marker = marker;
    point.marker_size = 1.4;
    add_point(point, finest, value);
    panel.series.push_back(std::move(point));
    text += fmt::format(" {} for the finest: {:.3g} m.", label, value);
  };
  estimate(mesh.extrapolated_error, Marker::triangle_up, "Richardson's estimate");
  estimate(mesh.grid_convergence_index, Marker::diamond, "grid convergence index");
  if (mesh.observed_order > 0) {
    panel.title = fmt::format("observed order of the mesh: {:.2f}", mesh.observed_order);
    text += fmt::format(" The observed order is {:.2f}.", mesh.observed_order);
  }
  Figure figure;
  figure.name = mesh_figure_name;
  figure.title = "Convergence of the mesh";
  figure.alt = text;
  figure.plot.title = figure.title;
  figure.plot.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

std::string certificate_in_words(const CertifiedReference& reference) {
  if (reference.certified)
    return fmt::format("certified: two methods agree to {:.2g} m, and the smallest error is {:.2g} m",
                       reference.agreement, reference.smallest_error);
  return "not certified: " + (reference.why_not.empty() ? "nothing was held against it" : reference.why_not);
}

std::vector<Figure> study_figures(const WorkPrecision& study) {
  std::vector<Figure> figures;
  if (!study_lines(study, StudyQuestion::time).empty()) {
    figures.push_back(WorkFigure(study, StudyQuestion::time).make());
    if (any_compared(study, StudyQuestion::total))
      figures.push_back(WorkFigure(study, StudyQuestion::total).make());
    figures.push_back(order_figure(study));
  }
  if (study.mesh && study.mesh->elements.size() > 1) figures.push_back(mesh_figure(*study.mesh));
  return figures;
}

}  // namespace plumb
