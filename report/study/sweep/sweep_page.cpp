#include <fmt/format.h>

#include "engine/base/file_writing.h"
#include "report/page/page_template.h"
#include "report/page/verdict_html.h"
#include "report/study/sweep/sweep_report.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view sweep_page_mustache;
extern const std::string_view page_css;
extern const std::string_view study_css;

namespace {

using kainjow::mustache::data;

constexpr std::size_t most_listed = 200;

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
    if (trouble.empty() || troubles++ >= most_listed) continue;
    data row;
    row["number"] = std::to_string(run.number);
    row["trouble"] = trouble;
    row["command"] = command_of(sweep, run);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::string to_sweep_page(const SweepResults& results, const std::vector<Picture>& pictures) {
  const Sweep& sweep = results.sweep;
  data page;
  page["title"] = sweep.loaded.spec.title;
  page["css"] = std::string(page_css) + std::string(study_css);
  page["headline"] = headline(results);
  page["good"] = all_passed(results.verdicts);
  page["cases"] = counted(std::ssize(sweep.runs), "case", "cases");
  page["seed"] = std::to_string(sweep.spec.seed);
  page["tolerance"] = fmt::format("{:g}", sweep.spec.tolerance);
  page["time_limit"] = fmt::format("{:g}", sweep.spec.time_limit);
  page["heads"] = outcome_heads(sweep);
  page["rows"] = count_rows(sweep);
  page["examples"] = example_rows(sweep);
  std::size_t troubles = 0;
  page["troubles"] = trouble_rows(sweep, troubles);
  page["has_troubles"] = troubles > 0;
  page["trouble_count"] = counted(static_cast<long>(troubles), "run", "runs");
  page["more_troubles"] = troubles > most_listed
                              ? fmt::format("{} more are in results.json.", troubles - most_listed)
                              : std::string();
  data figures{data::type::list};
  for (const Picture& picture : pictures) {
    data row;
    row["uri"] = data_uri(picture.png);
    row["alt"] = picture.alt;
    row["title"] = picture.title;
    row["file"] = picture.file;
    figures.push_back(row);
  }
  page.set("figures", figures);
  page["verdicts"] = verdict_html(results.verdicts);
  set_case_and_provenance(page, sweep.loaded.source, sweep.provenance, results.stages);
  return fill_in(sweep_page_mustache, page);
}

}  // namespace plumb
