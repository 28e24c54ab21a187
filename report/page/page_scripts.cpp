#include "report/page/page_scripts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/run/mode_table.h"
#include "report/base/base64.h"
#include "report/base/escape.h"
#include "report/page/glossary.h"
#include "report/page/page_template.h"

namespace plumb {

extern const std::string_view shell_mustache, page_css;
extern const std::string_view chart_min_js, chart_min_js_sha256;
extern const std::string_view report_js, report_js_sha256;
extern const std::string_view clock_js, clock_js_sha256;
extern const std::string_view player_js, player_js_sha256;
extern const std::string_view charts_js, charts_js_sha256;
extern const std::string_view downloads_js, downloads_js_sha256;
extern const std::string_view tables_js, tables_js_sha256;
extern const std::string_view verdict_filter_js, verdict_filter_js_sha256;

namespace {

std::string from_hex(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
  return bytes;
}

/// How far off each column of the run may be, as far as that is known: the root of the sum of squares of its
/// numerical parts and inputs, each at its greatest. No column: nothing is known.
std::map<std::string, double> column_uncertainties(const Document& document) {
  std::map<std::string, std::map<std::string, double>> parts;
  if (document.contains("uncertainty"))
    for (const Document& series : document.at("uncertainty").at("series"))
      for (const Document& part : series.at("parts")) {
        const std::string name = part.at("name").get<std::string>();
        // That of the reference is no part of the run.
        if (name == "data" || !part.contains("standard_uncertainty")) continue;
        double& greatest = parts[series.at("column").get<std::string>()][name];
        for (const Document& value : part.at("standard_uncertainty"))
          if (value.is_number()) greatest = std::max(greatest, value.get<double>());
      }
  std::map<std::string, double> result;
  for (const auto& [column, values] : parts)
    for (const auto& [name, value] : values) result[column] = std::hypot(result[column], value);
  return result;
}

/// Panels with how far off what their axes show may be.
Document with_uncertainties(Document panels, const std::map<std::string, double>& uncertainties) {
  for (Document& panel : panels)
    for (const char* key : {"x", "y"}) {
      Document& axis = panel.at(key);
      const auto found = uncertainties.find(axis.value("column", ""));
      if (found != uncertainties.end() && found->second > 0) axis["uncertainty"] = found->second;
    }
  return panels;
}

/// Of the figures with their numbers; those of sections are no charts.
Document figures_of(const Document& document) {
  Document figures = Document::array();
  const std::map<std::string, double> uncertainties = column_uncertainties(document);
  for (const auto& [key, list] : document.items()) {
    if (!is_figures_key(key)) continue;
    for (const Document& figure : list)
      if (figure.contains("panels"))
        figures.push_back({{"file", figure.at("file")},
                           {"title", figure.at("title")},
                           {"chart", key == figures_key},
                           {"panels", with_uncertainties(figure.at("panels"), uncertainties)}});
  }
  return figures;
}

}  // namespace

std::string html_page(const std::string& title, std::string_view css, const std::string& body,
                      const std::vector<PageScript>& scripts, const std::string& data) {
  std::string policy = scripts.empty() ? "" : "; script-src", elements = data;
  for (const PageScript& script : scripts) {
    policy += fmt::format(" 'sha256-{}'", base64(from_hex(script.sha256)));
    elements += fmt::format("<script>{}</script>\n", script.text);
  }
  kainjow::mustache::data page;
  page["title"] = title;
  page["script_policy"] = policy;
  page["has_scripts"] = !scripts.empty();
  page["css"] = std::string(page_css).append(css);
  page["body"] = with_captions(with_glossary(body));
  page["scripts"] = elements;
  return fill_in(shell_mustache, page);
}

std::string data_element(const std::string& id, const std::string& json) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id,
                     escape_json_for_html(json));
}

std::vector<PageScript> page_scripts(const std::vector<PageSection>& sections) {
  std::vector<PageScript> scripts{
      {chart_min_js, chart_min_js_sha256}, {report_js, report_js_sha256},
      {clock_js, clock_js_sha256},         {player_js, player_js_sha256},
      {charts_js, charts_js_sha256},       {downloads_js, downloads_js_sha256},
      {tables_js, tables_js_sha256},       {verdict_filter_js, verdict_filter_js_sha256}};
  for (const PageSection& section : sections)
    if (section.data) scripts.push_back(section.script);
  return scripts;
}

std::string page_data(const Document& document, const std::vector<PageSection>& sections) {
  const Document& animation = document.at("animation");
  Document own{{"figures", figures_of(document)},
               {"frame_rate", animation.at("player_frame_rate")},
               {"end_time", document.at("solve").at("end_time")}};
  // The period of a mode is that of the pictures.
  if (const double rate = animation.at("frame_rate").get<double>(); document.contains(modes_key) && rate > 0)
    own["end_time"] = (animation.at("frames").get<double>() - 1) / rate;
  std::string html = data_element("page-data", own.dump(-1, ' ', false, Document::error_handler_t::replace));
  for (const PageSection& section : sections)
    if (section.data) html += data_element(section.data_id, section.data(document.at(section.key)));
  return html;
}

}  // namespace plumb
