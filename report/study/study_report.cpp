#include "report/study/study_report.h"

#include <fmt/format.h>

#include "report/base/escape.h"
#include "report/document/case_json.h"
#include "report/page/page_template.h"
#include "report/page/verdict_html.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view study_page_mustache;
extern const std::string_view study_css;

namespace {

/// The lines of a text that there is room for.
std::string lines_within(const std::string& text, std::size_t room) {
  return text.size() <= room ? text : text.substr(0, room == 0 ? 0 : text.rfind('\n', room - 1) + 1);
}

/// What it concludes, and what that rests on.
std::string in_short(const StudyReport& report) {
  std::string text = report.headline;
  for (const std::string* more : {&report.details, &report.counts})
    if (!more->empty()) text += " " + *more;
  return text;
}

Document document_of(const StudyReport& report) {
  Document json;
  json["schema_version"] = results_version;
  json["title"] = report.loaded.spec.title;
  json["headline"] = in_short(report);
  // Where there is none, nothing is met.
  json["all_criteria_met"] = report.complete && all_met(report.verdicts);
  json["verdicts"] = Document::array();
  for (const Verdict& verdict : report.verdicts) json["verdicts"].push_back(verdict_json(verdict));
  json.update(report.results);
  json["case"] = case_json(report.loaded);
  for (const auto& [name, seconds] : report.stages.all()) json["seconds"][name] = seconds;
  for (const auto& [name, value] : report.provenance) json["provenance"][name] = value;
  return json;
}

std::string summary_of(const StudyReport& report) {
  constexpr std::size_t longest_text = 4000;
  std::string head = fmt::format("# {}: {}\n\n{}\n\n", escape_markdown(report.loaded.spec.title),
                                 escape_markdown(report.subject, longest_text),
                                 escape_markdown(report.headline, longest_text));
  for (const std::string* more : {&report.details, &report.counts})
    if (!more->empty()) head += escape_markdown(*more, longest_text) + "\n\n";
  const auto room = [&](std::size_t taken) { return longest_summary - std::min(longest_summary, taken); };
  // The verdicts go first where there is no room for all.
  const std::string verdicts = verdict_table(report.verdicts, room(head.size()));
  std::string text = head;
  if (!report.before.empty())
    text += lines_within(report.before, room(head.size() + verdicts.size() + 1)) + "\n";
  text += verdicts;
  return text + lines_within(report.after, room(text.size()));
}

}  // namespace

ReportContent content_of(const StudyReport& report) {
  return {report.loaded.spec.title, document_of(report), false, report.suites, summary_of(report)};
}

std::string to_page(const StudyReport& report, const StudySection& section) {
  kainjow::mustache::data page, links{kainjow::mustache::data::type::list};
  page["title"] = report.loaded.spec.title;
  page["subject"] = report.subject;
  page["headline"] = report.headline;
  page["details"] = report.details;
  page["has_details"] = !report.details.empty();
  page["counts"] = report.counts;
  page["has_counts"] = !report.counts.empty();
  page["good"] = report.complete && all_passed(report.verdicts);
  for (const auto& [id, text] : section.links) {
    kainjow::mustache::data entry;
    entry["id"] = id;
    entry["text"] = text;
    links.push_back(entry);
  }
  page.set("sections", links);
  page["section"] = section.html;
  page["has_verdicts"] = !report.verdicts.empty();
  page["verdicts"] = verdict_html(report.verdicts);
  page["verdict_note"] = section.verdict_note;
  set_case_and_provenance(page, report.loaded.source, report.provenance, report.stages, false);
  return html_page(report.loaded.spec.title + " – Plumb study", std::string(study_css) + section.css,
                   fill_in(study_page_mustache, page), section.scripts, section.data);
}

}  // namespace plumb
