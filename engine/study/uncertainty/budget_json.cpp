#include "engine/study/uncertainty/budget_json.h"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/base/codec.h"

namespace plumb {

template <class Archive>
void members(Archive& a, SeriesDistance& distance) {
  a("series", distance.series);
  a("from_reference", distance.from_reference);
  a("difference", distance.difference);
  if (!a.has("from_base", distance.from_base.has_value())) return;
  if (!distance.from_base) distance.from_base.emplace();
  a("from_base", distance.from_base->at_reference);
  a("from_base_time", distance.from_base->at_reference_time);
  a("from_base_sampled", distance.from_base->sampled);
  a("from_base_sampled_time", distance.from_base->sampled_time);
}

template <class Archive>
void members(Archive& a, BudgetRun& run) {
  a("overrides", run.overrides);
  a("outcome", run.outcome);
  a("message", run.message);
  a("method", run.method);
  a("elements", run.elements);
  a("solve_seconds", run.seconds);
  a("distances", run.distances);
}

template <class Archive>
void members(Archive& a, BudgetEntry& entry) {
  a("name", entry.name);
  a("reason", entry.reason);
  a("together", entry.together);
  a("numerical", entry.numerical);
  a("of_mesh", entry.of_mesh);
  a("of_run", entry.of_run);
  a("run", entry.run);
}

template <class Archive>
void members(Archive& a, BudgetSeries& series) {
  a("series", series.series);
  a("column", series.column);
  a("description", series.description);
  a("unit", series.unit);
}

template <class Archive>
void members(Archive& a, ErrorBudget& budget) {
  a("reference", budget.reference);
  a("left_out", budget.left_out);
  a("interval", budget.interval);
  a("time", budget.times);
  a("seconds", budget.seconds);
  a("series", budget.series);
  a("base", budget.base);
  a("items", budget.entries);
  a("all_together", budget.together);
}

namespace {

void check(const BudgetRun& run, const ErrorBudget& budget) {
  const std::size_t count = run.completed() ? budget.series.size() : 0;
  if (run.distances.size() != count)
    throw std::runtime_error(
        fmt::format("a run has distances of {} series of {}", run.distances.size(), count));
  for (std::size_t k = 0; k < count; ++k) {
    if (run.distances[k].series != budget.series[k].series)
      throw std::runtime_error("a run has the distances of other series");
    if (const std::size_t times = run.distances[k].difference.size();
        times != 0 && times != budget.times.size())
      throw std::runtime_error(fmt::format("{} differences for {} times", times, budget.times.size()));
    if (run.distances[k].from_base.has_value() != run.distances[0].from_base.has_value())
      throw std::runtime_error("a run has distances from the base for some series only");
  }
}

}  // namespace

nlohmann::ordered_json budget_json(const ErrorBudget& budget) {
  return encode(budget, NotFinite::null);
}

ErrorBudget budget_from_json(const nlohmann::ordered_json& json) {
  ErrorBudget budget = decoded<ErrorBudget>(json, NotFinite::null);
  check(budget.base, budget);
  check(budget.together, budget);
  for (const BudgetEntry& entry : budget.entries) check(entry.run, budget);
  return budget;
}

}  // namespace plumb
