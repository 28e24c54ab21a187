#include "engine/study/uncertainty/budget_json.h"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/base/json_numbers.h"
#include "engine/run/stored_parts.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json run_json(const BudgetRun& run, const std::vector<BudgetSeries>& series) {
  Json json{{"overrides", run.overrides}, {"outcome", word(run.outcome)},
            {"message", run.message},     {"method", run.method},
            {"elements", run.elements},   {"solve_seconds", number_to_json(run.seconds)}};
  json["distances"] = Json::array();
  for (std::size_t k = 0; k < run.from_reference.size(); ++k) {
    Json distance{{"series", series[k].series}, {"from_reference", number_to_json(run.from_reference[k])}};
    if (!run.from_base.empty()) {
      const BudgetDistance& base = run.from_base[k];
      distance["from_base"] = number_to_json(base.at_reference);
      distance["from_base_time"] = base.at_reference_time;
      distance["from_base_sampled"] = number_to_json(base.sampled);
      distance["from_base_sampled_time"] = base.sampled_time;
    }
    json["distances"].push_back(std::move(distance));
  }
  return json;
}

BudgetRun run_from_json(const Json& json, const std::vector<BudgetSeries>& series) {
  BudgetRun run;
  run.overrides = json.at("overrides").get<std::vector<std::string>>();
  run.outcome = outcome_named(json.at("outcome").get<std::string>());
  run.message = json.at("message").get<std::string>();
  run.method = json.at("method").get<std::string>();
  run.elements = json.at("elements").get<int>();
  run.seconds = number_from_json(json.at("solve_seconds"));
  const Json& distances = json.at("distances");
  if (distances.size() != (run.completed() ? series.size() : 0))
    throw std::runtime_error(
        fmt::format("a run has distances of {} series of {}", distances.size(), series.size()));
  for (const Json& item : distances) {
    run.from_reference.push_back(number_from_json(item.at("from_reference")));
    if (item.contains("from_base"))
      run.from_base.push_back(
          {number_from_json(item.at("from_base")), item.at("from_base_time").get<double>(),
           number_from_json(item.at("from_base_sampled")), item.at("from_base_sampled_time").get<double>()});
  }
  if (!run.from_base.empty() && run.from_base.size() != series.size())
    throw std::runtime_error("a run has distances from the base for some series only");
  return run;
}

}  // namespace

Json budget_json(const ErrorBudget& budget) {
  Json json{{"reference", budget.reference},
            {"left_out", budget.left_out},
            {"interval", budget.interval},
            {"reference_times", budget.reference_times},
            {"seconds", budget.seconds}};
  json["series"] = Json::array();
  for (const BudgetSeries& series : budget.series)
    json["series"].push_back({{"series", series.series},
                              {"column", series.column},
                              {"description", series.description},
                              {"unit", series.unit}});
  json["base"] = run_json(budget.base, budget.series);
  json["items"] = Json::array();
  for (const BudgetEntry& entry : budget.entries) {
    Json item{{"name", entry.name}, {"reason", entry.reason}, {"together", entry.together}};
    item["run"] = run_json(entry.run, budget.series);
    json["items"].push_back(std::move(item));
  }
  json["all_together"] = run_json(budget.together, budget.series);
  return json;
}

ErrorBudget budget_from_json(const Json& json) {
  ErrorBudget budget;
  budget.reference = json.at("reference").get<std::string>();
  budget.left_out = json.at("left_out").get<std::string>();
  budget.interval = json.at("interval").get<double>();
  budget.reference_times = json.at("reference_times").get<std::size_t>();
  budget.seconds = json.at("seconds").get<double>();
  for (const Json& item : json.at("series"))
    budget.series.push_back({item.at("series").get<std::string>(), item.at("column").get<std::string>(),
                             item.at("description").get<std::string>(), item.at("unit").get<std::string>()});
  budget.base = run_from_json(json.at("base"), budget.series);
  for (const Json& item : json.at("items"))
    budget.entries.push_back({item.at("name").get<std::string>(), item.at("reason").get<std::string>(),
                              item.at("together").get<bool>(), run_from_json(item.at("run"), budget.series)});
  budget.together = run_from_json(json.at("all_together"), budget.series);
  return budget;
}

}  // namespace plumb
