#include "report/page/page_scripts.h"

#include <fmt/format.h>

#include <vector>

#include "report/page/page_data.h"
#include "report/page/study_page.h"
#include "report/study/work_precision/study_chart_data.h"
#include "report/study/work_precision/work_precision_json.h"

namespace plumb {

extern const std::string_view chart_min_js, chart_min_js_sha256;
extern const std::string_view report_js, report_js_sha256;
extern const std::string_view clock_js, clock_js_sha256;
extern const std::string_view player_js, player_js_sha256;
extern const std::string_view charts_js, charts_js_sha256;
extern const std::string_view downloads_js, downloads_js_sha256;
extern const std::string_view tables_js, tables_js_sha256;
extern const std::string_view verdict_filter_js, verdict_filter_js_sha256;
extern const std::string_view study_js, study_js_sha256;

namespace {

struct Script {
  std::string_view text, sha256;
};

/// In the order in which they need each other.
std::vector<Script> scripts_of(const Document& document) {
  std::vector<Script> scripts{
      {chart_min_js, chart_min_js_sha256}, {report_js, report_js_sha256},
      {clock_js, clock_js_sha256},         {player_js, player_js_sha256},
      {charts_js, charts_js_sha256},       {downloads_js, downloads_js_sha256},
      {tables_js, tables_js_sha256},       {verdict_filter_js, verdict_filter_js_sha256}};
  if (document.contains("work_precision")) scripts.push_back({study_js, study_js_sha256});
  return scripts;
}

}  // namespace

std::string page_scripts(const Document& document) {
  std::string html = data_element("page-data", page_data(document));
  if (document.contains("work_precision"))
    html +=
        data_element("study-data", study_chart_data(work_precision_from_json(document.at("work_precision"))));
  for (const Script& script : scripts_of(document)) html += script_element(script.text);
  return html;
}

std::string page_script_policy(const Document& document) {
  std::vector<std::string_view> hashes;
  for (const Script& script : scripts_of(document)) hashes.push_back(script.sha256);
  return script_policy(hashes);
}

}  // namespace plumb
