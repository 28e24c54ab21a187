#include "report/page_template.h"

#include <stdexcept>

#include "report/base64.h"
#include "report/escape.h"

namespace plumb {

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

}  // namespace plumb
