#include "engine/study/uncertainty/run_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/integrate/integrate.h"
#include "engine/read/changed_case.h"
#include "engine/run/probes_json.h"
#include "engine/run/sampled_run.h"

namespace plumb {
namespace {

/// Of one run, s of the processor.
constexpr double longest_run_of_budget = 60;

/// A run of the budget with what its probes saw at the times of the reference and at each interval.
struct Computed {
  Case spec;
  BudgetRun run;
  ProbeTable at_reference;
  ProbeTable sampled;
};

/// As the journal keeps it, before it is measured.
template <class Archive>
void members(Archive& a, Computed& computed) {
  a("outcome", computed.run.outcome);
  a("message", computed.run.message);
  a("seconds", computed.run.seconds);
  a("at_reference", computed.at_reference);
  a("sampled", computed.sampled);
}

std::string in_words(const MethodSpec& method) {
  std::string text = method.name;
  if (method.step) text += fmt::format(", step {:.6g} s", *method.step);
  if (method.rtol) text += fmt::format(", rtol {:.6g}, atol {:.6g}", *method.rtol, *method.atol);
  return text;
}

std::vector<double> within(const std::vector<double>& times, double end) {
  std::vector<double> result;
  for (const double t : times)
    if (t <= end * (1 + 1e-9)) result.push_back(std::min(t, end));
  return result;
}

Computed compute(const Case& spec, const std::vector<Comparison>& compared,
                 const std::vector<double>& reference_times, double interval) {
  Computed computed;
  const Trajectory trajectory = integrate(spec, {}, longest_run_of_budget);
  BudgetRun& run = computed.run;
  run.outcome = trajectory.outcome;
  run.message = trajectory.message;
  run.seconds = trajectory.solve_seconds;
  if (!run.completed()) return computed;
  computed.at_reference =
      compared_columns(spec, trajectory, compared, within(reference_times, trajectory.times.back()));
  if (interval > 0) computed.sampled = compared_columns(spec, trajectory, compared, trajectory.times);
  return computed;
}

bool sets(const std::vector<std::string>& overrides, const std::string& key) {
  return std::any_of(overrides.begin(), overrides.end(),
                     [&](const std::string& text) { return text.starts_with(key + "="); });
}

/// Whether a case is already as an item would make it, but for the method.
bool is_in(const LoadedCase& loaded, const BudgetItemSpec& item) {
  const Case &own = loaded.spec, changed = load_changed(loaded.source, item.overrides).spec;
  return changed.cable == own.cable && changed.start == own.start && changed.supports == own.supports &&
         changed.loads == own.loads && changed.masses == own.masses && changed.damping == own.damping;
}

struct Greatest {
  double value = -1;
  double time = -1;
};

/// Of the differences of two lists of values; one that is not a number is greater than all others.
Greatest greatest_difference(const std::vector<double>& times, const std::vector<double>& a,
                             const std::vector<double>& b) {
  Greatest greatest;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    const double distance = std::abs(a[k] - b[k]);
    if (!(distance <= greatest.value)) greatest = {distance, times[k]};
    if (std::isnan(distance)) break;
  }
  return greatest;
}

void measure(Computed& computed, const Computed& base, const ErrorBudget& budget,
             const Reference& reference) {
  if (!computed.run.completed()) return;
  for (const BudgetSeries& series : budget.series) {
    const auto values = [&](const ProbeTable& table) -> const std::vector<double>& {
      return table.find(series.column)->values;
    };
    const std::vector<double>& own = values(computed.at_reference);
    SeriesDistance& distance = computed.run.distances.emplace_back();
    distance.series = series.series;
    distance.from_reference =
        greatest_difference(computed.at_reference.times, own, reference.find(series.series)->values).value;
    if (&computed == &base || !base.run.completed()) continue;
    const std::vector<double>& of_base = values(base.at_reference);
    for (std::size_t k = 0; k < own.size(); ++k) distance.difference.push_back(own[k] - of_base[k]);
    const Greatest there = greatest_difference(computed.at_reference.times, own, of_base);
    Greatest often;
    if (budget.interval > 0)
      often = greatest_difference(computed.sampled.times, values(computed.sampled), values(base.sampled));
    distance.from_base = {there.value, there.time, often.value, often.time};
  }
}

}  // namespace

ErrorBudget run_budget(const LoadedCase& loaded, Runner& runner) {
  const auto started = std::chrono::steady_clock::now();
  const BudgetSpec& spec = *loaded.spec.error_budget;
  const auto use = std::find_if(loaded.spec.references.begin(), loaded.spec.references.end(),
                                [&](const ReferenceUse& any) { return any.name == spec.reference; });
  const Reference& reference =
      loaded.references[static_cast<std::size_t>(use - loaded.spec.references.begin())];

  ErrorBudget budget;
  budget.reference = spec.reference;
  budget.interval = spec.interval;
  for (const Comparison& pair : use->compare) {
    const ReferenceSeries& series = *reference.find(pair.series);
    budget.series.push_back({pair.series, pair.column, series.description, series.unit});
  }

  // The base, all together, and then each item.
  std::vector<Computed> all;
  const auto add = [&](const std::vector<std::string>& overrides) {
    Computed computed;
    computed.spec = load_changed(loaded.source, overrides).spec;
    if (spec.interval > 0) computed.spec.time.output_interval = spec.interval;
    computed.run.overrides = overrides;
    all.push_back(std::move(computed));
  };
  add(spec.overrides);
  std::vector<std::string> together = spec.overrides;
  for (const BudgetItemSpec& item : spec.items)
    if (item.together) together = joined_overrides(std::move(together), item.overrides);
  add(together);
  for (const BudgetItemSpec& item : spec.items) add(joined_overrides(spec.overrides, item.overrides));

  budget.left_out = difference(reference.cable, all.front().spec.cable);
  if (!budget.left_out.empty()) budget.left_out = "the reference is for another cable: " + budget.left_out;
  if (reference.times.front() > loaded.spec.time.end)
    budget.left_out = "no time of the reference is within the run";
  else if (const std::vector<double> times = within(reference.times, loaded.spec.time.end);
           !(times.back() > 0))
    budget.left_out = "no time of the reference is within the run but the start";
  if (!budget.left_out.empty()) return budget;

  std::vector<StudyPoint<Computed>> points;
  for (const Computed& planned : all)
    points.push_back({fmt::format("run {}", points.size()),
                      [&] { return compute(planned.spec, use->compare, reference.times, spec.interval); },
                      1.0 * planned.spec.cable.elements});
  std::vector<Computed> made = runner.run("error budget", points);
  for (std::size_t k = 0; k < all.size(); ++k) {
    made[k].run.overrides = all[k].run.overrides;
    made[k].run.elements = all[k].spec.cable.elements;
    made[k].run.method = in_words(all[k].spec.method);
    made[k].spec = std::move(all[k].spec);
  }
  all = std::move(made);
  for (Computed& computed : all) measure(computed, all.front(), budget, reference);
  budget.times = within(reference.times, loaded.spec.time.end);
  budget.base = std::move(all[0].run);
  budget.together = std::move(all[1].run);
  for (std::size_t k = 0; k < spec.items.size(); ++k) {
    const BudgetItemSpec& item = spec.items[k];
    budget.entries.push_back({item.name, item.reason, item.together, item.numerical,
                              sets(item.overrides, "cable.elements"), is_in(loaded, item),
                              std::move(all[2 + k].run)});
  }
  budget.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return budget;
}

}  // namespace plumb
