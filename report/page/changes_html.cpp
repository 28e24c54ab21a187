#include "report/page/changes_html.h"

#include <fmt/format.h>

#include "report/page/page_template.h"

namespace plumb {

extern const std::string_view changes_mustache;

namespace {

using kainjow::mustache::data;

data part(const std::string& title, const Document& since) {
  data rows{data::type::list};
  for (const Document& change : since.at("changes")) {
    data row;
    for (const char* key : {"what", "before", "now"}) row[key] = change.at(key).get<std::string>();
    rows.push_back(row);
  }
  const std::string made_at = since.at("made_at").get<std::string>();
  data values;
  values["title"] = title + (made_at.empty() ? "" : fmt::format(", made at {}", made_at));
  values["none"] = since.at("changes").empty();
  values["any"] = !since.at("changes").empty();
  values.set("changes", rows);
  return values;
}

}  // namespace

std::string changes_html(const Document& document) {
  data parts{data::type::list};
  if (document.contains("baseline"))
    parts.push_back(part("Since the baseline " + document["baseline"].at("folder").get<std::string>(),
                         document["baseline"]));
  if (document.contains("last_run")) parts.push_back(part("Since the last run", document["last_run"]));
  if (parts.list_value().empty()) return "";
  data values;
  values.set("parts", parts);
  return fill_in(changes_mustache, values);
}

}  // namespace plumb
