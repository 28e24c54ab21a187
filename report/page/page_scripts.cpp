#include "report/page/page_scripts.h"

#include <fmt/format.h>

#include <vector>

#include "report/page/study_page.h"

namespace plumb {

extern const std::string_view chart_min_js, chart_min_js_sha256;
extern const std::string_view report_js, report_js_sha256;
extern const std::string_view clock_js, clock_js_sha256;
extern const std::string_view player_js, player_js_sha256;
extern const std::string_view charts_js, charts_js_sha256;
extern const std::string_view downloads_js, downloads_js_sha256;
extern const std::string_view tables_js, tables_js_sha256;
extern const std::string_view verdict_filter_js, verdict_filter_js_sha256;

namespace {

struct Script {
  std::string_view text, sha256;
};

/// In the order in which they need each other.
std::vector<Script> scripts_of(const std::vector<PageSection>& sections) {
  std::vector<Script> scripts{
      {chart_min_js, chart_min_js_sha256}, {report_js, report_js_sha256},
      {clock_js, clock_js_sha256},         {player_js, player_js_sha256},
      {charts_js, charts_js_sha256},       {downloads_js, downloads_js_sha256},
      {tables_js, tables_js_sha256},       {verdict_filter_js, verdict_filter_js_sha256}};
  for (const PageSection& section : sections)
    if (section.data) scripts.push_back({section.script, section.script_sha256});
  return scripts;
}

/// Of the figures with their numbers; those of sections are no charts.
Document figures_of(const Document& document) {
  Document figures = Document::array();
  for (const auto& [key, list] : document.items()) {
    if (!is_figures_key(key)) continue;
    for (const Document& figure : list)
      if (figure.contains("panels"))
        figures.push_back({{"file", figure.at("file")},
                           {"title", figure.at("title")},
                           {"chart", key == figures_key},
                           {"panels", figure.at("panels")}});
  }
  return figures;
}

/// On one line, with how the frames of the animation follow each other.
std::string page_data(const Document& document) {
  const Document shown{{"figures", figures_of(document)},
                       {"frame_rate", document.at("animation").at("player_frame_rate")},
                       {"end_time", document.at("solve").at("end_time")}};
  return shown.dump(-1, ' ', false, Document::error_handler_t::replace);
}

}  // namespace

std::string page_scripts(const Document& document, const std::vector<PageSection>& sections) {
  std::string html = data_element("page-data", page_data(document));
  for (const PageSection& section : sections)
    if (section.data) html += data_element(section.data_id, section.data(document.at(section.key)));
  for (const Script& script : scripts_of(sections)) html += script_element(script.text);
  return html;
}

std::string page_script_policy(const std::vector<PageSection>& sections) {
  std::vector<std::string_view> hashes;
  for (const Script& script : scripts_of(sections)) hashes.push_back(script.sha256);
  return script_policy(hashes);
}

}  // namespace plumb
