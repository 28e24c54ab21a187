#include "report/index/run_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/base/escape.h"
#include "report/document/junit_suites.h"
#include "report/page/verdict_html.h"

namespace plumb {
namespace {

std::string text(const Document& object, const char* key) {
  return object.at(key).get<std::string>();
}

long count(const Document& verdicts, const char* status) {
  return std::count_if(verdicts.begin(), verdicts.end(),
                       [&](const Document& verdict) { return verdict.at("status") == status; });
}

/// A run that ended before there was anything to report.
Document entry_without_report(const std::string& folder) {
  return {{"folder", folder},
          {"case", ""},
          {"title", folder},
          {"headline", "The run left no report."},
          {"outcome", "not run"},
          {"complete", false},
          {"all_criteria_met", false},
          {"criteria", 0},
          {"failed", 0},
          {"not_run", 0},
          {"method", ""},
          {"elements", -1},
          {"solve_seconds", -1},
          {"verdicts", Document::array()}};
}

Document entry(const IndexedReport& report) {
  if (report.document.is_null()) return entry_without_report(report.folder);
  const Document &document = report.document, &solve = document.at("solve");
  const long failed = count(document.at("verdicts"), "failed"),
             not_run = count(document.at("verdicts"), "not run");
  return {{"folder", report.folder},
          {"case", document.at("case").at("file")},
          {"title", document.at("title")},
          {"headline", document.at("headline")},
          {"outcome", document.at("outcome")},
          {"complete", document.at("complete")},
          {"all_criteria_met", document.at("all_criteria_met")},
          {"criteria", document.at("verdicts").size()},
          {"failed", failed},
          {"not_run", not_run},
          {"method", solve.at("method")},
          {"elements", solve.at("elements")},
          {"solve_seconds", solve.at("solve_seconds")},
          {"verdicts", document.at("verdicts")}};
}

/// What failed comes first, then what was not run.
int rank(const Document& entry) {
  if (!entry.at("complete").get<bool>()) return 0;
  if (entry.at("failed").get<long>() > 0) return 1;
  return entry.at("all_criteria_met").get<bool>() || entry.at("criteria").get<long>() == 0 ? 3 : 2;
}

std::string headline(const Document& entries) {
  const auto all = std::ssize(entries);
  const auto failed =
      std::count_if(entries.begin(), entries.end(), [](const Document& one) { return rank(one) < 3; });
  const auto none = std::count_if(entries.begin(), entries.end(),
                                  [](const Document& one) { return one.at("criteria").get<long>() == 0; });
  if (failed == 0 && none == all)
    return fmt::format("None of {} reports names a criterion, so nothing is claimed.", all);
  if (failed == 0)
    return none == 0 ? fmt::format("All criteria of all {} reports are met.", all)
                     : fmt::format("All criteria of {} of {} reports are met; the others name none.",
                                   all - none, all);
  std::string names;
  for (const Document& one : entries)
    if (rank(one) < 3) names += (names.empty() ? "" : ", ") + text(one, "folder");
  return fmt::format("{} of {} reports do not meet all of their criteria: {}.", failed, all, names);
}

}  // namespace

std::vector<Figure> shared_figures(const std::vector<IndexedReport>& reports) {
  // Columns in the order of the first report that has them, with their unit.
  std::vector<std::pair<std::string, std::string>> columns;
  for (const IndexedReport& report : reports) {
    if (report.document.is_null()) continue;
    for (const auto& [name, probe] : report.document.at("probes").items()) {
      const std::pair column(name, text(probe, "unit"));
      if (name != "t" && std::find(columns.begin(), columns.end(), column) == columns.end())
        columns.push_back(column);
    }
  }
  std::vector<Figure> figures;
  for (const auto& [name, unit] : columns) {
    Panel panel;
    panel.x.label = "time [s]";
    panel.y.label = fmt::format("{} [{}]", name, unit);
    for (const IndexedReport& report : reports) {
      if (report.document.is_null()) continue;
      const Document& probes = report.document.at("probes");
      if (!probes.contains(name) || probes[name].at("unit") != unit) continue;
      Series series;
      series.label = report.folder;
      const Document &times = probes.at("t").at("values"), &values = probes[name].at("values");
      for (std::size_t i = 0; i < values.size() && i < times.size(); ++i) {
        if (!values[i].is_number()) continue;
        series.x.push_back(times[i].get<double>());
        series.y.push_back(values[i].get<double>());
      }
      series.dash = panel.series.size() % 2 == 0 ? Dash::solid : Dash::dashed;
      panel.series.push_back(std::move(series));
    }
    if (panel.series.size() < 2) continue;
    Figure figure;
    figure.name = "shared_" + name;
    figure.title = fmt::format("{} of {} runs", name, panel.series.size());
    figure.alt =
        fmt::format("Plot of {} over time, one line for each of {} runs.", name, panel.series.size());
    figure.plot.title = figure.title;
    figure.plot.height = 900;
    figure.plot.panels.push_back(std::move(panel));
    figures.push_back(std::move(figure));
    if (figures.size() == most_shared_figures) break;
  }
  return figures;
}

Document index_of(const std::vector<IndexedReport>& reports, const std::vector<Picture>& figures) {
  std::vector<Document> entries;
  for (const IndexedReport& report : reports) entries.push_back(entry(report));
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Document& a, const Document& b) { return rank(a) < rank(b); });
  Document index;
  index["schema_version"] = results_version;
  index["kind"] = "index";
  index["headline"] = headline(Document(entries));
  const auto met = [](const Document& one) { return one.at("all_criteria_met").get<bool>(); };
  index["all_criteria_met"] =
      std::any_of(entries.begin(), entries.end(), met) &&
      std::all_of(entries.begin(), entries.end(), [](const Document& one) { return rank(one) == 3; });
  index["reports"] = entries;
  index["figures"] = Document::array();
  for (const Picture& figure : figures)
    index["figures"].push_back({{"file", figure.file}, {"title", figure.title}, {"alt", figure.alt}});
  return index;
}

std::vector<JunitSuite> index_suites(const std::vector<IndexedReport>& reports) {
  std::vector<JunitSuite> all;
  for (const IndexedReport& report : reports) {
    if (report.document.is_null()) {
      all.push_back({report.folder + ".integration",
                     {{"integration", VerdictStatus::failed, "the run left no report"}}});
      continue;
    }
    for (JunitSuite& suite : suites_of(report.document)) {
      suite.name = fmt::format("{}.{}", report.folder, suite.name);
      all.push_back(std::move(suite));
    }
  }
  return all;
}

std::string index_summary(const Document& index) {
  constexpr std::size_t size_limit = 60 * 1024;
  std::string summary = fmt::format("# Plumb: {} reports\n\n{}\n\n", index.at("reports").size(),
                                    escape_markdown(text(index, "headline")));
  summary += "| report | outcome | criteria | not met | not run | |\n| --- | --- | --- | --- | --- | --- |\n";
  std::size_t left_out = 0;
  for (const Document& one : index.at("reports")) {
    const std::string row =
        fmt::format("| {} | {} | {} | {} | {} | {} |\n", escape_markdown(text(one, "folder")),
                    rank(one) == 3 ? escape_markdown(text(one, "outcome"))
                                   : fmt::format("**{}**", escape_markdown(text(one, "outcome"))),
                    one.at("criteria").get<long>(), one.at("failed").get<long>(),
                    one.at("not_run").get<long>(), escape_markdown(text(one, "headline")));
    if (summary.size() + row.size() > size_limit)
      ++left_out;
    else
      summary += row;
  }
  if (left_out > 0) summary += fmt::format("\n{} more reports are in results.json.\n", left_out);
  return summary;
}

}  // namespace plumb
