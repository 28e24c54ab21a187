#include "report/study/uncertainty/budget_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/figure/number_markup.h"
#include "report/study/panel_parts.h"

namespace plumb {
namespace {

constexpr Color together_color = Color::hex(0x3A3F48);
constexpr Color information_color = Color::hex(0xB4BAC4);

/// What the bars of one colour are of.
struct Kind {
  std::string label;
  Color color;
  const BudgetRun* run;
};

std::vector<Kind> kinds_of(const ErrorBudget& budget) {
  std::vector<Kind> kinds;
  std::size_t next = 0;
  for (const BudgetEntry& entry : budget.entries)
    if (entry.together) kinds.push_back({entry.name, palette[next++ % palette.size()], &entry.run});
  kinds.push_back({"all together", together_color, &budget.together});
  for (const BudgetEntry& entry : budget.entries)
    if (!entry.together) kinds.push_back({entry.name + " (for information)", information_color, &entry.run});
  return kinds;
}

double distance(const ErrorBudget& budget, const BudgetRun& run, std::size_t series) {
  if (run.distances.empty() || !run.distances[series].from_base) return -1;
  const BudgetDistance& from_base = *run.distances[series].from_base;
  return budget.interval > 0 ? from_base.sampled : from_base.at_reference;
}

}  // namespace

Figure budget_figure(const ErrorBudget& budget) {
  const std::vector<Kind> kinds = kinds_of(budget);
  Panel panel;
  panel.y.label = fmt::format("greatest distance to the base run [{}]",
                              budget.series.empty() ? "m" : unit_markup(budget.series.front().unit));
  constexpr double group_width = 0.84;
  const double width = group_width / static_cast<double>(kinds.size());
  double highest = 0;
  std::string text;
  for (std::size_t s = 0; s < budget.series.size(); ++s) {
    const double middle = static_cast<double>(s) + 1;
    panel.x.ticks.push_back(middle);
    panel.x.tick_labels.push_back(budget.series[s].column);
    text += fmt::format(" {}:", budget.series[s].column);
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const double value = distance(budget, *kinds[k].run, s);
      const bool known = value >= 0 && std::isfinite(value);
      text +=
          fmt::format("{} {} {}", k == 0 ? "" : ",", kinds[k].label,
                      known ? fmt::format("{:.2g} {}", value, budget.series[s].unit) : "did not complete");
      if (!known) continue;
      const double left = middle - group_width / 2 + width * static_cast<double>(k);
      constexpr double gap = 0.08;
      panel.bars.push_back(
          {{left + gap / 2 * width, left + (1 - gap / 2) * width}, {0, value}, kinds[k].color});
      highest = std::max(highest, value);
    }
    text += ".";
  }
  for (const Kind& kind : kinds) panel.series.push_back(bar_key(kind.label, kind.color));
  panel.x.range = {0.5, static_cast<double>(budget.series.size()) + 0.5};
  panel.y.range = {0.0, highest > 0 ? 1.08 * highest : 1.0};

  Figure figure;
  figure.name = budget_figure_name;
  figure.title = "Error budget: what each thing, changed alone, moves the series by";
  figure.alt = fmt::format(
      "Bar chart with a group of bars for each series: the greatest distance from the run that repeats "
      "\"{}\", "
      "over {}.{}",
      budget.reference,
      budget.interval > 0 ? fmt::format("every {:g} s", budget.interval)
                          : std::string("the times of the reference"),
      text);
  figure.plot.title = figure.title;
  figure.plot.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace plumb
