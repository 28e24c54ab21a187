#include <fmt/format.h>

#include "report/page/page_template.h"
#include "report/study/sweep/sweep_results.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view sweep_mustache;

namespace {

using kainjow::mustache::data;

constexpr std::size_t most_troubles = 200;

data outcome_heads(const Sweep& sweep) {
  data heads{data::type::list};
  for (const Outcome outcome : shown_outcomes(sweep))
    heads.push_back(data{"outcome", std::string(word(outcome))});
  return heads;
}

data count_row(const Sweep& sweep, const std::string& name, const OutcomeCounts& counts) {
  long all = 0;
  for (const auto& [outcome, count] : counts) all += count;
  data cells{data::type::list};
  for (const Outcome outcome : shown_outcomes(sweep)) {
    const auto found = counts.find(outcome);
    const long count = found == counts.end() ? 0 : found->second;
    data cell;
    cell["count"] = std::to_string(count);
    cell["share"] = share_in_words(count, all);
    cells.push_back(cell);
  }
  data row;
  row["name"] = name;
  row["runs"] = std::to_string(all);
  row.set("cells", cells);
  return row;
}

data count_rows(const Sweep& sweep) {
  data rows{data::type::list};
  rows.push_back(count_row(sweep, "all methods", outcome_counts(sweep)));
  for (const auto& [method, counts] : outcome_counts_by_method(sweep))
    rows.push_back(count_row(sweep, method, counts));
  return rows;
}

/// The first run of each outcome, so that each can be looked at.
data example_rows(const Sweep& sweep) {
  data rows{data::type::list};
  for (const Outcome outcome : shown_outcomes(sweep))
    for (const SweepRun& run : sweep.runs) {
      if (run.outcome != outcome) continue;
      data row;
      row["outcome"] = std::string(word(outcome));
      row["number"] = std::to_string(run.number);
      row["message"] = !run.message.empty() ? run.message
                       : run.error >= 0
                           ? fmt::format("{:.3g} m from the reference, {:.3g} m from the second one",
                                         run.error, run.second_error)
                           : "";
      row["command"] = command_of(sweep, run);
      rows.push_back(row);
      break;
    }
  return rows;
}

data trouble_rows(const Sweep& sweep, std::size_t& troubles) {
  data rows{data::type::list};
  for (const SweepRun& run : sweep.runs) {
    const std::string trouble = trouble_of(run, sweep.spec.tolerance);
    if (trouble.empty() || troubles++ >= most_troubles) continue;
    data row;
    row["number"] = std::to_string(run.number);
    row["trouble"] = trouble;
    row["command"] = command_of(sweep, run);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

StudySection shown_sweep(const Sweep& sweep, const std::vector<Picture>& pictures) {
  data values;
  values["cases"] = counted(std::ssize(sweep.runs), "case", "cases");
  values["seed"] = std::to_string(sweep.spec.seed);
  values["tolerance"] = fmt::format("{:g}", sweep.spec.tolerance);
  values["time_limit"] = fmt::format("{:g}", sweep.spec.time_limit);
  values["heads"] = outcome_heads(sweep);
  values["rows"] = count_rows(sweep);
  values["examples"] = example_rows(sweep);
  std::size_t troubles = 0;
  values["troubles"] = trouble_rows(sweep, troubles);
  values["has_troubles"] = troubles > 0;
  values["trouble_count"] = counted(static_cast<long>(troubles), "run", "runs");
  values["more_troubles"] = troubles > most_troubles
                                ? fmt::format("{} more are in results.json.", troubles - most_troubles)
                                : std::string();
  values.set("figures", picture_rows(pictures));
  return {{{"outcomes", "Outcomes"}, {"wrong", "What is wrong"}, {"examples", "Examples"}},
          fill_in(sweep_mustache, values),
          "All are <strong>verification</strong>: of what the program says of its own runs."};
}

}  // namespace plumb
