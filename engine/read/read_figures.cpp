#include <fmt/format.h>

#include <algorithm>

#include "engine/base/nearest.h"
#include "engine/case/name_rule.h"
#include "engine/case/probe_columns.h"
#include "engine/case/reference.h"
#include "engine/read/case_sections.h"

namespace plumb {
namespace {

void check_column(const TableReader& table, std::string_view key, const std::string& column,
                  const ProbeColumns& columns, std::string_view or_else) {
  if (columns.unit(column) || column == or_else) return;
  std::vector<std::string> known = columns.names();
  if (!or_else.empty()) known.emplace_back(or_else);
  table.refuse_value(key, "not a column of the probes" + suggestion(column, known));
}

void check_reference(const TableReader& table, const FigureSpec& figure,
                     const std::vector<ReferenceUse>& references) {
  std::vector<std::string> names;
  for (const ReferenceUse& use : references) names.push_back(use.name);
  const auto found = std::find(names.begin(), names.end(), figure.reference);
  if (found == names.end()) {
    const std::string end = names.empty() ? "; the case has none" : suggestion(figure.reference, names);
    table.refuse_value("reference", "not the name of a [[reference]]" + end);
  }
  const ReferenceUse& use = references[static_cast<std::size_t>(found - names.begin())];
  for (const std::string& column : {figure.x, figure.y}) {
    const auto compares = [&](const Comparison& comparison) { return comparison.column == column; };
    if (column == word(Abscissa::time) || column == word(Abscissa::mode) ||
        std::any_of(use.compare.begin(), use.compare.end(), compares))
      continue;
    table.refuse_value("reference", fmt::format("that reference does not compare {}", column));
  }
}

}  // namespace

std::vector<FigureSpec> read_figures(std::vector<TableReader> tables, const std::vector<ProbeSpec>& probes,
                                     const std::vector<ReferenceUse>& references, bool of_modes) {
  const ProbeColumns columns(probes, of_modes);
  const std::string abscissa(word(of_modes ? Abscissa::mode : Abscissa::time));
  const std::string abscissa_unit = of_modes ? "1" : "s";
  std::vector<FigureSpec> figures;
  for (TableReader& table : tables) {
    FigureSpec figure;
    figure.name = table.text("name", "a name, which the picture's file gets");
    figure.title = table.optional_text("title", figure.name);
    figure.x = table.optional_text("x", abscissa);
    figure.y = table.text("y", "a column of the probes");
    figure.x_label = table.optional_text("x_label", figure.x);
    figure.y_label = table.optional_text("y_label", figure.y);
    figure.reference = table.optional_text("reference", "");
    figure.equal_axes = table.flag("equal_axes", false);
    table.finish();

    if (!follows_name_rule(figure.name)) table.refuse_value("name", fmt::format("must be {}", name_rule));
    const auto same = [&](const FigureSpec& other) { return other.name == figure.name; };
    if (std::any_of(figures.begin(), figures.end(), same))
      table.refuse_value("name", "is the name of another figure");
    check_column(table, "x", figure.x, columns, abscissa);
    check_column(table, "y", figure.y, columns, "");
    const std::string_view x_unit = columns.unit(figure.x).value_or(abscissa_unit),
                           y_unit = columns.unit(figure.y).value();
    if (figure.equal_axes && x_unit != y_unit) {
      table.refuse_value("equal_axes",
                         fmt::format("the axes have different units, {} and {}", x_unit, y_unit));
    }
    if (!figure.reference.empty()) check_reference(table, figure, references);
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace plumb
