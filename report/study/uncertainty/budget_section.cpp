#include "report/study/uncertainty/budget_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/study/uncertainty/budget_json.h"
#include "report/figure/number_markup.h"
#include "report/page/page_template.h"
#include "report/study/uncertainty/budget_figure.h"

namespace plumb {

extern const std::string_view budget_mustache;

namespace {

using kainjow::mustache::data;
using Json = Document;

constexpr const char* budget_key = "error_budget";
constexpr const char* budget_figures_key = "error_budget_figures";

/// Two digits, as a distance between two computations means no more. -1 is none.
std::string distance_text(const Json& json) {
  if (!json.is_number()) return "not finite";
  const double value = json.get<double>();
  return value < 0 ? "–" : fmt::format("{:.2g}", value);
}

data cells(const Json& run, const Json& series, const char* key, bool sampled) {
  data row{data::type::list};
  const Json& distances = run.at("distances");
  for (std::size_t k = 0; k < series.size(); ++k) {
    const bool known = k < distances.size() && distances[k].contains(key);
    data cell;
    cell["value"] = known ? distance_text(distances[k].at(key)) : "–";
    cell["sampled"] =
        known && sampled ? distance_text(distances[k].at(std::string(key) + "_sampled")) : std::string("–");
    cell["has_sampled"] = sampled;
    row.push_back(cell);
  }
  return row;
}

data run_row(const std::string& name, const Json& run, const Json& series, const char* key, bool sampled) {
  data row;
  row["name"] = name;
  row["how"] = fmt::format("{}, {} elements", text_of(run, "method"), run.at("elements").get<int>());
  const bool completed = text_of(run, "outcome") == "completed";
  row["failed"] = !completed;
  row["message"] = fmt::format("{}: {}", text_of(run, "outcome"), text_of(run, "message"));
  row.set("cells", cells(run, series, key, sampled));
  return row;
}

data override_rows(const Json& overrides) {
  data rows{data::type::list};
  for (const Json& text : overrides) rows.push_back(data{"override", text.get<std::string>()});
  return rows;
}

/// The greatest over the series, not a number where any of them is none; -1 where there is none.
double greatest(const Json& run, const char* key) {
  double value = -1;
  for (const Json& distance : run.at("distances")) {
    if (!distance.contains(key)) continue;
    if (!distance.at(key).is_number()) return std::numeric_limits<double>::quiet_NaN();
    value = std::max(value, distance.at(key).get<double>());
  }
  return value;
}

/// What the budget comes to, in one sentence: "Error budget of published: …".
std::string budget_in_words(const Document& budget) {
  const std::string reference = text_of(budget, "reference");
  if (const std::string why = text_of(budget, "left_out"); !why.empty())
    return fmt::format("No error budget of {}: {}.", reference, why);
  const std::string unit = budget.at("series").empty() ? "" : text_of(budget.at("series").front(), "unit");
  const auto amount = [&](const Json& run, const char* key) -> std::string {
    const double value = greatest(run, key);
    if (std::isnan(value)) return std::string("no finite distance");
    if (value >= 0) return fmt::format("{:.2g}{}", value, unit_after(unit));
    const std::string outcome = text_of(run, "outcome");
    return outcome == "completed" ? std::string("not compared") : outcome;
  };
  std::string items;
  for (const Json& item : budget.at("items")) {
    if (!item.at("together").get<bool>()) continue;
    items += fmt::format("{}{} {}", items.empty() ? "" : ", ", text_of(item, "name"),
                         amount(item.at("run"), "from_base"));
  }
  return fmt::format(
      "Error budget of {}: the same computation repeats it to {}; changed alone, {} at most; all together "
      "{}.",
      reference, amount(budget.at("base"), "from_reference"), items,
      amount(budget.at("all_together"), "from_base"));
}

std::string budget_html(const Document& budget, const std::vector<Picture>& pictures) {
  data values;
  values["summary"] = budget_in_words(budget);
  values["reference"] = text_of(budget, "reference");
  values["done"] = text_of(budget, "left_out").empty();
  if (text_of(budget, "left_out").empty()) {
    const Json& series = budget.at("series");
    const double interval = budget.at("interval").get<double>();
    const bool sampled = interval > 0;
    values["sampled"] = sampled;
    values["interval"] = fmt::format("{:g}", interval);
    values["columns"] = sampled ? "2" : "1";
    values["times"] = std::to_string(budget.at("time").size());
    values["seconds"] = fmt::format("{:.2g}", budget.at("seconds").get<double>());
    data heads{data::type::list};
    for (const Json& item : series) {
      data head;
      head["column"] = text_of(item, "column");
      head["description"] = text_of(item, "description");
      head["unit"] = unit_text(text_of(item, "unit"));
      head["has_sampled"] = sampled;
      heads.push_back(head);
    }
    values.set("series", heads);
    data rows{data::type::list};
    bool any_reason = false;
    for (const Json& item : budget.at("items")) {
      const bool together = item.at("together").get<bool>();
      data row = run_row(text_of(item, "name") + (together ? "" : " (for information)"), item.at("run"),
                         series, "from_base", sampled);
      row["reason"] = text_of(item, "reason");
      row["has_reason"] = !text_of(item, "reason").empty();
      any_reason = any_reason || !text_of(item, "reason").empty();
      rows.push_back(row);
    }
    rows.push_back(run_row("all together", budget.at("all_together"), series, "from_base", sampled));
    values.set("items", rows);
    values["has_reasons"] = any_reason;
    data distances{data::type::list};
    distances.push_back(run_row("the base run", budget.at("base"), series, "from_reference", false));
    distances.push_back(run_row("all together", budget.at("all_together"), series, "from_reference", false));
    values.set("distances", distances);
    values.set("overrides", override_rows(budget.at("base").at("overrides")));
    values["has_overrides"] = !budget.at("base").at("overrides").empty();
    values.set("pictures", picture_rows(pictures));
  }
  return fill_in(budget_mustache, values);
}

}  // namespace

RunSection budget_section(const ErrorBudget& budget) {
  RunSection section{.key = budget_key,
                     .json = budget_json(budget),
                     .figures_key = budget_figures_key,
                     .drawing_stage = "budget figure"};
  if (budget.left_out.empty()) section.figures = [budget] { return std::vector{budget_figure(budget)}; };
  return section;
}

PageSection budget_on_page() {
  return {.key = budget_key,
          .id = "budget",
          .link = "Error budget",
          .title = "Error budget",
          .html = budget_html,
          .figures_key = budget_figures_key,
          .line = budget_in_words};
}

}  // namespace plumb
