#include "report/page/modes_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/run/mode_table.h"
#include "report/base/document_value.h"
#include "report/document/case_json.h"
#include "report/figure/number_markup.h"
#include "report/page/page_template.h"

namespace plumb {

extern const std::string_view modes_mustache;

namespace {

using kainjow::mustache::data;

/// Digits enough to hold a frequency against a printed one. What is round-off beside the greatest of its unit
/// is 0.
std::string six_digits(const Document& value, double greatest) {
  constexpr double round_off = 1e-9;
  if (!value.is_number()) return "not finite";
  const double number = value.get<double>();
  return std::abs(number) <= round_off * greatest ? "0" : fmt::format("{:.6g}", number);
}

std::string modes_html(const Document& modes, const std::vector<Picture>&) {
  data values;
  const Document &columns = modes.at("columns"), &kinds = modes.at("kind");
  data heads{data::type::list};
  std::vector<std::pair<const Document*, std::string>> shown;
  std::map<std::string, double> greatest;
  for (const auto& [name, column] : columns.items()) {
    const std::string unit = text_of(column, "unit");
    heads.push_back(data{"head", unit == "1" ? name : fmt::format("{} [{}]", name, unit_text(unit))});
    shown.emplace_back(&column.at("values"), unit);
    for (const Document& value : column.at("values"))
      if (value.is_number()) greatest[unit] = std::max(greatest[unit], std::abs(value.get<double>()));
  }
  values.set("heads", heads);
  data rows{data::type::list};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    data row, cells{data::type::list};
    row["number"] = std::to_string(k + 1);
    row["kind"] = kinds.at(k).get<std::string>();
    for (const auto& [column, unit] : shown)
      cells.push_back(data{"cell", six_digits(column->at(k), greatest[unit])});
    row.set("cells", cells);
    row["residual"] = fmt::format("{:.1e}", modes.at("residual").at(k).get<double>());
    rows.push_back(row);
  }
  values.set("rows", rows);
  const double spin = modes.at("spin").get<double>(),
               orthonormality = modes.at("orthonormality").get<double>();
  const long rigid = modes.at("rigid_body").get<long>();
  values["any"] = !kinds.empty();
  values["rigid"] = rigid == 0   ? "none of them a rigid-body motion"
                    : rigid == 1 ? "one of them a rigid-body motion"
                                 : fmt::format("{} of them rigid-body motions", rigid);
  values["spins"] = spin > 0;
  values["spin"] = fmt::format("{:.6g}", spin);
  const Document& axis = modes.at("axis");
  values["axis"] = fmt::format("({:.4g}, {:.4g}, {:.4g})", axis.at(0).get<double>(), axis.at(1).get<double>(),
                               axis.at(2).get<double>());
  values["is_orthonormal"] = orthonormality >= 0;
  values["orthonormality"] = fmt::format("{:.1e}", orthonormality);
  return fill_in(modes_mustache, values);
}

std::string modes_in_words(const Document& modes) {
  const Document& kinds = modes.at("kind");
  return fmt::format("modes: {}, {} of them rigid-body motions", kinds.size(),
                     modes.at("rigid_body").get<long>());
}

}  // namespace

RunSection modes_section(const Run& run) {
  return {.key = std::string(modes_key), .json = modes_json(run)};
}

PageSection modes_on_page() {
  return {.key = std::string(modes_key),
          .id = std::string(modes_key),
          .link = "Modes",
          .title = "Modes",
          .html = modes_html,
          .line = modes_in_words};
}

}  // namespace plumb
