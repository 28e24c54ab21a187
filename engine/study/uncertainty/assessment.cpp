#include "engine/study/uncertainty/assessment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/known_time.h"
#include "engine/base/parse_json.h"
#include "engine/base/place.h"
#include "engine/study/uncertainty/budget_json.h"
#include "engine/study/uncertainty/uncertainty_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse_other_run(const std::string& what) {
  throw std::runtime_error("it is that of another run: " + what);
}

void check_series(const SeriesUncertainty& series, const Run& run) {
  const std::string name = fmt::format("{}: {}", series.reference, series.column);
  const Case& spec = run.loaded.spec;
  const auto use = std::find_if(spec.references.begin(), spec.references.end(),
                                [&](const ReferenceUse& any) { return any.name == series.reference; });
  if (use == spec.references.end() ||
      std::find(use->compare.begin(), use->compare.end(), Comparison{series.series, series.column}) ==
          use->compare.end())
    refuse_other_run(name + " is not compared");
  const Reference& reference = run.loaded.references[static_cast<std::size_t>(use - spec.references.begin())];
  const std::vector<double>& values = reference.find(series.series)->values;
  std::vector<double> data;
  for (const double t : series.times) {
    const std::optional<KnownTime> known = known_time(reference.times, t);
    if (!known || !known->output || run.trajectory.times.empty() || t > run.trajectory.times.back())
      refuse_other_run(name + " has other times");
    data.push_back(values[known->before]);
  }
  // What is stored repeats to the last digit, but for another processor's rounding.
  constexpr double rounding = 1e-9;
  const std::vector<double> seen = probe(spec, run.trajectory, series.times).find(series.column)->values;
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (std::abs(seen[k] - data[k] - series.error[k]) > rounding * (1 + std::abs(seen[k])))
      refuse_other_run(fmt::format("{} differs from the reference by {:.6g} at {} s, and there by {:.6g}",
                                   name, seen[k] - data[k], series.times[k], series.error[k]));
}

void check_budget(const ErrorBudget& budget, const Case& spec) {
  if (!spec.error_budget) refuse_other_run("the case has no error budget");
  const std::vector<BudgetItemSpec>& items = spec.error_budget->items;
  const bool same = budget.left_out.empty()
                        ? budget.entries.size() == items.size() &&
                              std::equal(items.begin(), items.end(), budget.entries.begin(),
                                         [](const BudgetItemSpec& item, const BudgetEntry& entry) {
                                           return item.name == entry.name;
                                         })
                        : budget.entries.empty();
  if (!same || budget.reference != spec.error_budget->reference)
    refuse_other_run("the case has another error budget");
}

Assessment read(const std::string& text, const std::string& file, const Run& run) {
  const Json json = parse_json<Json>(text, file);
  if (json.at("kind").get<std::string>() != "assessment") throw std::runtime_error("it is no assessment");
  if (const int version = json.at("version").get<int>(); version != assessment_version)
    throw std::runtime_error(
        fmt::format("its version is {}, this program reads version {}", version, assessment_version));
  Assessment assessment;
  if (json.contains("uncertainty")) {
    assessment.uncertainty = uncertainty_from_json(json.at("uncertainty"));
    for (const SeriesUncertainty& series : assessment.uncertainty->series) check_series(series, run);
  }
  if (json.contains("error_budget")) {
    assessment.error_budget = budget_from_json(json.at("error_budget"));
    check_budget(*assessment.error_budget, run.loaded.spec);
  }
  return assessment;
}

}  // namespace

std::string encode_assessment(const Assessment& assessment) {
  Json json{{"kind", "assessment"}, {"version", assessment_version}};
  if (assessment.uncertainty) json["uncertainty"] = uncertainty_json(*assessment.uncertainty);
  if (assessment.error_budget) json["error_budget"] = budget_json(*assessment.error_budget);
  return to_summed_text(std::move(json), 1);
}

Assessment decode_assessment(const std::string& text, const std::string& file, const Run& run) {
  try {
    return read(text, file, run);
  } catch (...) {
    refuse_unusable(file);
  }
}

}  // namespace plumb
