#include "report/page/history_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "report/base/document_value.h"
#include "report/base/escape.h"
#include "report/document/history.h"
#include "report/figure/number_markup.h"
#include "report/page/svg_chart.h"
#include "report/page/verdict_html.h"

namespace plumb {
namespace {

/// "9a7fc58, 2026-11-30 19:24:20 UTC, on host"
std::string title_of(const Document& run) {
  return fmt::format("{}\n{}\n{}", text_of(run, "revision"), text_of(run, "made_at"), text_of(run, "host"));
}

/// Runs one after another, the first and the last with their revision.
SvgAxis axis_of_runs(const Document& runs) {
  const auto last = static_cast<double>(runs.size());
  const auto shown = [](const Document& run) { return text_of(run, "revision").substr(0, 9); };
  SvgAxis axis{0.5, last + 0.5, false, "runs, by revision", {{1, shown(runs.front())}}};
  if (runs.size() > 1) axis.ticks.emplace_back(last, shown(runs.back()));
  return axis;
}

/// A chart of one value a run.
struct Trend {
  std::string name, unit;
  std::vector<double> values, limits;  ///< one a run; NaN: none
  std::vector<std::string> classes;
};

std::string chart_of(const Trend& trend, const Document& runs, double height) {
  SvgChart chart;
  chart.height = height;
  chart.x = axis_of_runs(runs);
  std::vector<double> all = trend.values;
  all.insert(all.end(), trend.limits.begin(), trend.limits.end());
  // What spans less than a decade is seen better as it is.
  double lo = std::numeric_limits<double>::infinity(), hi = 0;
  for (const double value : all)
    if (value > 0) {
      lo = std::min(lo, value);
      hi = std::max(hi, value);
    }
  const bool wide = hi > 10 * lo;
  if (!wide) all.push_back(0);
  chart.y = fitted_axis(all, wide, unit_text(trend.unit));
  if (!wide) chart.y.from = 0;
  chart.alt = fmt::format("{} over {} runs, the last {:.4g}{}.", trend.name, runs.size(), trend.values.back(),
                          unit_after(trend.unit));
  SvgLine values{{}, "trend"}, limits{{}, "limit"};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const auto x = static_cast<double>(k + 1);
    values.points.emplace_back(x, trend.values[k]);
    limits.points.emplace_back(x, trend.limits[k]);
    std::string title = fmt::format("{:.4g}{}", trend.values[k], unit_after(trend.unit));
    if (std::isfinite(trend.limits[k]))
      title += fmt::format(" of {:.4g}{}", trend.limits[k], unit_after(trend.unit));
    chart.marks.push_back({x, trend.values[k], trend.classes[k], title + "\n" + title_of(runs[k])});
  }
  // A limit of one run is a line all the same.
  if (runs.size() == 1 && std::isfinite(trend.limits.front()))
    limits.points = {{0.5, trend.limits.front()}, {1.5, trend.limits.front()}};
  chart.lines = {limits, values};
  return to_svg(chart);
}

std::string figure_of(const Trend& trend, const Document& runs, const std::string& caption, double height) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", chart_of(trend, runs, height),
                     escape_xml(caption));
}

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Seconds of the time loop where they were taken on the processor of the last run.
Trend times_of(const Document& runs) {
  Trend trend{"Seconds of the time loop", "s", {}, {}, {}};
  for (const Document& run : runs) {
    const double seconds = number_of(run.at("solve_seconds"));
    const bool alike = run.at("processor") == runs.back().at("processor");
    trend.values.push_back(alike && seconds > 0 ? seconds : missing);
    trend.limits.push_back(missing);
    trend.classes.emplace_back("time");
  }
  return trend;
}

bool any_finite(const Trend& trend) {
  return std::any_of(trend.values.begin(), trend.values.end(), [](double v) { return std::isfinite(v); });
}

/// A value of a criterion that was not run is none.
double found(const Document& criterion) {
  return criterion.at("status") == "not run" ? missing : number_of(criterion.at("value"));
}

std::vector<Trend> criteria_of(const Document& runs) {
  std::vector<Trend> trends;
  for (const Document& last : runs.back().at("criteria")) {
    Trend trend{text_of(last, "name"), text_of(last, "unit"), {}, {}, {}};
    for (const Document& run : runs) {
      const Document* own = nullptr;
      for (const Document& criterion : run.at("criteria"))
        if (criterion.at("name") == last.at("name") && criterion.at("unit") == last.at("unit"))
          own = &criterion;
      trend.values.push_back(own ? found(*own) : missing);
      trend.limits.push_back(own ? number_of(own->at("limit")) : missing);
      trend.classes.push_back(own ? class_of_status(text_of(*own, "status")) : "");
    }
    if (any_finite(trend)) trends.push_back(std::move(trend));
  }
  return trends;
}

/// Of each run the criterion that uses most of what it is allowed.
Trend worst_of(const Document& runs) {
  Trend trend{"Greatest share of what is allowed", "of allowed", {}, {}, {}};
  for (const Document& run : runs) {
    double worst = missing;
    std::string status;
    for (const Document& criterion : run.at("criteria")) {
      const double limit = number_of(criterion.at("limit"));
      if (criterion.at("status") == "another model" || !(limit > 0)) continue;
      const double share = found(criterion) / limit;
      if (!std::isfinite(share) || share <= worst) continue;
      worst = share;
      status = text_of(criterion, "status");
    }
    trend.values.push_back(worst);
    trend.limits.push_back(1);
    trend.classes.push_back(class_of_status(status));
  }
  return trend;
}

std::string section_html(const Document& history, const std::vector<Picture>&) {
  const Document& runs = history.at("runs");
  std::string html = fmt::format(
      "<p>{} of this case in <span class=\"file\">{}</span>, the latest {}; the last is this one. Point at a "
      "mark for its revision.</p>\n<div class=\"trends\">\n",
      runs.size() == 1 ? "One run" : fmt::format("{} runs", runs.size()),
      escape_xml(text_of(history, "file")), most_runs_of_history);
  constexpr double height = 180;
  for (const Trend& trend : criteria_of(runs))
    html += figure_of(
        trend, runs,
        trend.name + (trend.unit == "1" ? "" : ", " + unit_text(trend.unit)) + "; dashed: what is allowed",
        height);
  if (const Trend times = times_of(runs); any_finite(times))
    html +=
        figure_of(times, runs,
                  "Time loop, s by the clock, of runs on this processor, whatever ran beside them", height);
  return html + "</div>\n";
}

}  // namespace

std::string history_in_small(const Document& runs) {
  constexpr double height = 140;
  std::string html;
  if (const Trend worst = worst_of(runs); any_finite(worst))
    html += figure_of(worst, runs, "Greatest share of what a criterion allows", height);
  if (const Trend times = times_of(runs); any_finite(times))
    html += figure_of(times, runs, "Time loop, s", height);
  return html;
}

PageSection history_on_page() {
  return {.key = history_key,
          .place = PagePlace::cost,
          .id = "history",
          .link = "Over revisions",
          .title = "Over revisions",
          .html = section_html,
          .css = history_css};
}

}  // namespace plumb
