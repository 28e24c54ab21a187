#include "report/index/run_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "engine/base/time_interpolation.h"
#include "render/gl/markup.h"
#include "report/base/document_value.h"
#include "report/base/escape.h"
#include "report/document/junit_suites.h"
#include "report/figure/number_markup.h"
#include "report/index/comparisons.h"
#include "report/index/study_as_report.h"

namespace plumb {
namespace {

long count(const Document& verdicts, const char* status) {
  return std::count_if(verdicts.begin(), verdicts.end(),
                       [&](const Document& verdict) { return verdict.at("status") == status; });
}

constexpr const char *failed_to_run = "failed to run", *nothing = "not held against anything",
                     *another_model = "another model";

/// In one word or some what is to be thought of a report: how it failed to run, else what its verdicts say.
std::string state_of(const Document& document) {
  if (document.is_null() || !document.at("complete").get<bool>()) return failed_to_run;
  const Document& verdicts = document.at("verdicts");
  for (const char* status : {"failed", "not run"})
    if (count(verdicts, status) > 0) return status;
  return count(verdicts, "passed") > 0 ? "passed" : verdicts.empty() ? nothing : another_model;
}

/// What failed comes first, then what was not run, and last what nothing was said of.
int rank(const Document& entry) {
  static constexpr std::array order{failed_to_run, "failed", "not run", "passed", another_model, nothing};
  const auto* const found = std::find(order.begin(), order.end(), entry.at("state"));
  return static_cast<int>(found - order.begin());
}

/// The kind of evidence that tells most of what a report has: figures that were published before solutions,
/// these before work, and last Plumb's own earlier output; empty where there is none.
std::string kind_of(const Document& verdicts) {
  for (const VerdictKind kind : {VerdictKind::validation, VerdictKind::verification, VerdictKind::performance,
                                 VerdictKind::regression})
    for (const Document& verdict : verdicts)
      if (verdict.at("kind") == word(kind)) return std::string(word(kind));
  return "";
}

bool is_bad(const Document& entry) {
  return rank(entry) < 3;
}

/// A run that ended before there was anything to report.
Document entry_of_none(const IndexedReport& report, const std::string& name) {
  return {{"folder", report.folder},
          {"name", name},
          {"state", failed_to_run},
          {"kind", ""},
          {"case", ""},
          {"title", name},
          {"headline", report.fault.empty() ? "The run left no report."
                                            : fmt::format("The run left no report: {}.", report.fault)},
          {"outcome", "not run"},
          {"outcome_reason", report.fault.empty() ? "the run left no report" : report.fault},
          {"exit_status", report.exit_status},
          {"complete", false},
          {"all_criteria_met", false},
          {"criteria", 0},
          {"failed", 0},
          {"not_run", 0},
          {"another_model", 0},
          {"method", ""},
          {"elements", -1},
          {"solve_seconds", -1},
          {"verdicts", Document::array()}};
}

Document entry(const IndexedReport& report, const std::string& name) {
  if (report.document.is_null()) return entry_of_none(report, name);
  const Document &document = report.document, &solve = document.at("solve"),
                 &verdicts = document.at("verdicts");
  return {{"folder", report.folder},
          {"name", name},
          {"state", state_of(document)},
          {"kind", kind_of(verdicts)},
          {"case", document.at("case").at("file")},
          {"title", document.at("title")},
          {"headline", document.at("headline")},
          {"outcome", document.at("outcome")},
          {"outcome_reason", document.at("outcome_reason")},
          {"exit_status", report.exit_status},
          {"complete", document.at("complete")},
          {"all_criteria_met", document.at("all_criteria_met")},
          {"criteria", verdicts.size()},
          {"failed", count(verdicts, "failed")},
          {"not_run", count(verdicts, "not run")},
          {"another_model", count(verdicts, another_model)},
          {"method", solve.at("method")},
          {"elements", solve.at("elements")},
          {"solve_seconds", solve.at("solve_seconds")},
          {"verdicts", verdicts}};
}

std::string headline(const Document& entries) {
  constexpr long most_named = 8;
  const auto all = std::ssize(entries);
  const auto failed = std::count_if(entries.begin(), entries.end(), is_bad);
  const auto none =
      std::count_if(entries.begin(), entries.end(), [](const Document& one) { return rank(one) > 3; });
  if (failed == 0 && none == all)
    return fmt::format("None of {} reports has a criterion that was judged, so nothing is claimed.", all);
  if (failed == 0)
    return none == 0 ? fmt::format("All criteria of all {} reports are met.", all)
                     : fmt::format(
                           "All criteria of {} of {} reports are met; the others are held against "
                           "nothing that judges them.",
                           all - none, all);
  std::string names;
  long named = 0;
  for (const Document& one : entries)
    if (is_bad(one) && named++ < most_named) names += (names.empty() ? "" : ", ") + text_of(one, "name");
  if (failed > most_named) names += fmt::format(" and {} more", failed - most_named);
  return fmt::format("{} of {} reports {} not meet all of {} criteria: {}.", failed, all,
                     failed == 1 ? "does" : "do", failed == 1 ? "its" : "their", names);
}

}  // namespace

namespace {

/// The second of two curves minus the first, at the times of both that both span; empty: there are none.
Series difference_of(const Series& first, const Series& second) {
  Series series;
  if (first.x.empty() || second.x.empty() || !is_rising(first.x) || !is_rising(second.x)) return series;
  std::set<double> times(first.x.begin(), first.x.end());
  times.insert(second.x.begin(), second.x.end());
  const TimeInterpolation one(first.x, first.y), other(second.x, second.y);
  for (const double t : times)
    if (t >= std::max(first.x.front(), second.x.front()) && t <= std::min(first.x.back(), second.x.back())) {
      series.x.push_back(t);
      series.y.push_back(other.value(t) - one.value(t));
    }
  return series;
}

std::vector<std::string> report_names(const std::vector<IndexedReport>& reports) {
  std::vector<std::string> folders;
  for (const IndexedReport& report : reports) folders.push_back(report.folder);
  return names_of(folders);
}

}  // namespace

std::vector<std::string> names_of(const std::vector<std::string>& folders) {
  constexpr std::string_view up = "../";
  std::vector<std::string> names = folders;
  while (!names.empty() && std::all_of(names.begin(), names.end(),
                                       [&](const std::string& name) { return name.starts_with(up); }))
    for (std::string& name : names) name.erase(0, up.size());
  return names;
}

std::vector<Figure> shared_figures(const std::vector<IndexedReport>& reports) {
  const std::vector<std::string> names = report_names(reports);
  // Columns in the order of the first report that has them, with their unit.
  std::vector<std::pair<std::string, std::string>> columns;
  for (const IndexedReport& report : reports) {
    if (report.document.is_null()) continue;
    for (const auto& [name, probe] : report.document.at("probes").items()) {
      const std::pair column(name, text_of(probe, "unit"));
      if (name != "t" && std::find(columns.begin(), columns.end(), column) == columns.end())
        columns.push_back(column);
    }
  }
  std::vector<Figure> figures;
  for (const auto& [name, unit] : columns) {
    Panel panel;
    panel.x.label = "time [s]";
    panel.y.label = fmt::format("{} [{}]", literal(name), unit_markup(unit));
    for (std::size_t k = 0; k < reports.size(); ++k) {
      const IndexedReport& report = reports[k];
      if (report.document.is_null()) continue;
      const Document& probes = report.document.at("probes");
      if (!probes.contains(name) || probes[name].at("unit") != unit) continue;
      Series series;
      series.label = literal(names[k]);
      const Document &times = probes.at("t").at("values"), &values = probes[name].at("values");
      for (std::size_t i = 0; i < values.size() && i < times.size(); ++i) {
        if (!values[i].is_number()) continue;
        series.x.push_back(times[i].get<double>());
        series.y.push_back(values[i].get<double>());
      }
      series.dash = panel.series.size() % 2 == 0 ? Dash::solid : Dash::dashed;
      panel.series.push_back(std::move(series));
    }
    if (panel.series.size() < 2 || panel.series.size() > most_shared_lines) continue;
    Figure figure;
    figure.name = "shared_" + name;
    figure.title = fmt::format("{} of {} runs", name, panel.series.size());
    figure.alt =
        fmt::format("Plot of {} over time, one line for each of {} runs.", name, panel.series.size());
    figure.plot.title = literal(figure.title);
    figure.times = {{true, {}}};
    figure.plot.height = 900;
    if (reports.size() == 2) {
      Panel below;
      below.x.label = panel.x.label;
      below.y.label = fmt::format("difference [{}]", unit_markup(unit));
      below.y.zero_line = true;
      below.height_share = 0.4;
      below.series = {difference_of(panel.series[0], panel.series[1])};
      if (!below.series[0].x.empty()) {
        panel.shares_x_below = true;
        figure.plot.panels.push_back(std::move(panel));
        panel = std::move(below);
        figure.times.push_back(figure.times.front());
      }
    }
    figure.plot.panels.push_back(std::move(panel));
    figures.push_back(std::move(figure));
    if (figures.size() == most_shared_figures) break;
  }
  return figures;
}

IndexedReport indexed(const std::string& folder, const Document& document) {
  IndexedReport report{folder, document};
  report.document["comparisons"] = comparisons_of(document, folder);
  std::vector<std::string> heavy{"errors",     "energy",    "animation",
                                 "given_runs", history_key, study_results_key};
  for (const auto& [key, value] : document.items())
    if (is_figures_key(key)) heavy.push_back(key);
  for (const std::string& key : heavy) report.document.erase(key);
  report.document["case"].erase("text");
  return report;
}

Document index_of(const std::vector<IndexedReport>& reports, const std::vector<Picture>& figures,
                  std::size_t at_once, const History& history) {
  const std::vector<std::string> names = report_names(reports);
  std::vector<Document> entries;
  Document comparisons = Document::array();
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const IndexedReport& report = reports[k];
    Document one = entry(report, names[k]);
    if (!report.document.is_null())
      for (const Document& comparison : report.document.at("comparisons")) comparisons.push_back(comparison);
    if (!history.entries.empty())
      one[history_key] =
          of_same_case(history, report.document.is_null()
                                    ? Document{{"case", report.folder}, {"overrides", Document::array()}}
                                    : history_entry(report.document));
    entries.push_back(std::move(one));
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Document& a, const Document& b) { return rank(a) < rank(b); });
  Document index;
  index["schema_version"] = results_version;
  index["kind"] = "index";
  index["headline"] = headline(Document(entries));
  const auto met = [](const Document& one) { return one.at("all_criteria_met").get<bool>(); };
  index["all_criteria_met"] = std::any_of(entries.begin(), entries.end(), met) &&
                              std::none_of(entries.begin(), entries.end(), is_bad);
  if (at_once > 0) index["at_once"] = at_once;
  index["reports"] = entries;
  index["statistics"] = statistics_of(comparisons);
  index["comparisons"] = std::move(comparisons);
  index[figures_key] = Document::array();
  for (const Picture& figure : figures)
    index[figures_key].push_back({{"file", figure.file}, {"title", figure.title}, {"alt", figure.alt}});
  return index;
}

std::vector<JunitSuite> index_suites(const std::vector<IndexedReport>& reports) {
  std::vector<JunitSuite> all;
  for (const IndexedReport& report : reports) {
    if (report.document.is_null()) {
      all.push_back(
          {report.folder + ".integration",
           {{"integration", VerdictStatus::failed,
             report.fault.empty() ? "the run left no report" : "the run left no report: " + report.fault}}});
      continue;
    }
    // A study as a whole integrates nothing.
    const bool study = report.document.value("is_study", false);
    for (JunitSuite& suite : study ? suites_of(verdicts_of(report.document)) : suites_of(report.document)) {
      suite.name = fmt::format("{}.{}", report.folder, suite.name);
      all.push_back(std::move(suite));
    }
  }
  return all;
}

std::string index_summary(const Document& index) {
  constexpr std::size_t for_the_end = 3 * 1024, longest_text = 4000, shortest_row = 120;
  const Document& reports = index.at("reports");
  std::string summary = fmt::format("# Plumb: {} reports\n\n{}\n\n", reports.size(),
                                    escape_markdown(text_of(index, "headline"), longest_text));
  summary += "| report | outcome | criteria | not met | not run | |\n| --- | --- | --- | --- | --- | --- |\n";
  const std::size_t room = longest_summary - for_the_end - summary.size();
  const auto row_within = [](const Document& one, std::size_t most) {
    std::string row = fmt::format(
        "| {} | {} | {} | {} | {} | ", escape_markdown(text_of(one, "name"), longest_text),
        is_bad(one) ? fmt::format("**{}**", escape_markdown(text_of(one, "outcome")))
                    : escape_markdown(text_of(one, rank(one) > 3 ? "state" : "outcome")),
        one.at("criteria").get<long>(), one.at("failed").get<long>(), one.at("not_run").get<long>());
    constexpr std::string_view end = " |\n";
    const std::size_t left = most - std::min(most, row.size() + end.size());
    return row.append(escape_markdown(text_of(one, "headline"), left)).append(end);
  };
  // Of many reports each says less, rather than some nothing at all.
  std::size_t whole = 0;
  for (const Document& one : reports) whole += row_within(one, longest_text).size();
  const std::size_t most =
      whole <= room ? longest_text : std::max(shortest_row, room / std::max<std::size_t>(1, reports.size()));
  std::string rows;
  std::size_t shown = 0;
  for (const Document& one : reports) {  // what failed first
    const std::string row = row_within(one, most);
    if (rows.size() + row.size() > room) break;
    rows += row;
    ++shown;
  }
  summary += rows;
  if (shown < reports.size())
    summary += fmt::format("\n{} more reports are in results.json.\n", reports.size() - shown);
  for (const Document& one : index.at("statistics"))
    if (one.at("spread").is_number())
      summary += fmt::format("\n{}: bias {:.4g}, spread {:.2g} over {} comparisons.\n",
                             escape_markdown(text_of(one, "kind")), one.at("bias").get<double>(),
                             one.at("spread").get<double>(),
                             one.at("comparisons").get<long>() - one.at("left_out").get<long>());
  return summary;
}

}  // namespace plumb
