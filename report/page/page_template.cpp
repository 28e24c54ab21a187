#include "report/page/page_template.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "report/base/base64.h"
#include "report/base/escape.h"

namespace plumb {

extern const std::string_view case_source_mustache, provenance_mustache;

using kainjow::mustache::data;

std::string fill_in(std::string_view text, const data& values) {
  kainjow::mustache::mustache page{std::string(text)};
  page.set_custom_escape([](const std::string& raw) { return escape_xml(raw); });
  if (!page.is_valid()) throw std::logic_error("page template: " + page.error_message());
  return page.render(values);
}

std::string data_uri(const std::string& png) {
  return "data:image/png;base64," + base64(png);
}

data pair_rows(const std::vector<std::pair<std::string, std::string>>& items) {
  data rows{data::type::list};
  for (const auto& [name, value] : items) {
    data row;
    row["name"] = name;
    row["value"] = value;
    rows.push_back(row);
  }
  return rows;
}

data picture_values(const Picture& picture, const std::string& more) {
  data values;
  values["title"] = picture.title;
  values["caption"] = picture.title + "." + more;
  values["alt"] = picture.alt;
  values["tall"] = picture.tall;
  values["file"] = picture.file;
  std::string image = fmt::format(R"(<img src="{}" alt="{}" width="800">)",
                                  data_uri(picture.page_png.empty() ? picture.png : picture.page_png),
                                  escape_xml(picture.alt));
  if (!picture.dark_png.empty())
    image = fmt::format(
        R"html(<picture><source media="screen and (prefers-color-scheme: dark)" srcset="{}">{}</picture>)html",
        data_uri(picture.dark_png), image);
  values["image"] = image;
  return values;
}

data picture_rows(const std::vector<Picture>& pictures) {
  data rows{data::type::list};
  for (const Picture& picture : pictures) rows.push_back(picture_values(picture));
  return rows;
}

void set_case_and_provenance(data& page, const CaseSource& source, const Provenance& provenance,
                             const Stages& stages, bool open) {
  data the_case, overrides{data::type::list}, made_with;
  the_case["case_name"] = source.file.name;
  the_case["case_text"] = source.file.text;
  the_case["open"] = open;
  for (const std::string& text : source.overrides) overrides.push_back(data{"override", text});
  the_case["has_overrides"] = !source.overrides.empty();
  the_case.set("overrides", overrides);
  page["case_source"] = fill_in(case_source_mustache, the_case);
  std::vector<std::pair<std::string, std::string>> times;
  for (const auto& [name, seconds] : stages.all()) times.emplace_back(name, fmt::format("{:.2f} s", seconds));
  made_with["provenance"] = pair_rows(provenance);
  made_with["stages"] = pair_rows(times);
  page["provenance"] = fill_in(provenance_mustache, made_with);
}

void set_case_and_provenance(data& page, const nlohmann::ordered_json& document) {
  const auto& the_case = document.at("case");
  CaseSource source;
  source.file = {the_case.at("file").get<std::string>(), the_case.at("text").get<std::string>()};
  source.overrides = the_case.at("overrides").get<std::vector<std::string>>();
  Provenance provenance;
  for (const auto& [name, value] : document.at("provenance").items())
    provenance.emplace_back(name, value.get<std::string>());
  Stages stages;
  for (const auto& [name, seconds] : document.at("seconds").items()) stages.add(name, seconds.get<double>());
  set_case_and_provenance(page, source, provenance, stages, true);
}

}  // namespace plumb
