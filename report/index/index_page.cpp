#include <fmt/format.h>

#include "report/index/run_index.h"
#include "report/page/page_scripts.h"
#include "report/page/page_template.h"
#include "report/page/verdict_html.h"

namespace plumb {

extern const std::string_view index_mustache;

namespace {

using kainjow::mustache::data;

/// A path as the target of a link: what is not plain is escaped by percent signs.
std::string link_to(const std::string& path) {
  std::string link;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || c == '.' || c == '/' || c == '~';
    link += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return link;
}

data report_row(const Document& report) {
  const auto text = [&](const char* key) { return report.at(key).get<std::string>(); };
  const auto number = [&](const char* key) { return std::to_string(report.at(key).get<long>()); };
  const bool met = report.at("all_criteria_met").get<bool>();
  const bool failed = !report.at("complete").get<bool>() || report.at("failed").get<long>() > 0;
  data row;
  for (const char* key : {"folder", "title", "headline", "outcome", "method"}) row[key] = text(key);
  for (const char* key : {"criteria", "failed", "not_run", "elements"}) row[key] = number(key);
  const double seconds = report.at("solve_seconds").get<double>();
  row["seconds"] = seconds < 0 ? "not run" : fmt::format("{:.3g} s", seconds);
  row["link"] = link_to(text("folder")) + "/index.html";
  row["class"] = failed ? "failed" : met ? "passed" : "not-run";
  row["has_verdicts"] = !report.at("verdicts").empty();
  row["verdicts"] = verdict_html(verdicts_of(report));
  return row;
}

}  // namespace

std::string index_page(const Document& index, const std::vector<Picture>& figures) {
  data page;
  page["count"] = std::to_string(index.at("reports").size());
  page["headline"] = index.at("headline").get<std::string>();
  page["good"] = index.at("all_criteria_met").get<bool>();
  data reports{data::type::list};
  for (const Document& report : index.at("reports")) reports.push_back(report_row(report));
  page.set("reports", reports);
  page["has_figures"] = !figures.empty();
  page.set("figures", picture_rows(figures));
  return html_page(fmt::format("{} Plumb reports", index.at("reports").size()), "",
                   fill_in(index_mustache, page));
}

}  // namespace plumb
