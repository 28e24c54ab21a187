#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "engine/base/nearest.h"
#include "engine/case/case_source.h"
#include "engine/case/case_words.h"
#include "engine/case/name_rule.h"
#include "engine/read/table_reader.h"

namespace plumb {
namespace {

const Range half_width = Range::positive("half-width, in the unit of the series");

ReferenceSeries read_series(TableReader table, const std::vector<ReferenceSeries>& others) {
  ReferenceSeries series;
  series.name = table.text("name", "a name");
  series.figure = table.text("figure", "where the series stands in the source, \"Fig. 3\"");
  series.unit = table.text("unit", "the unit of the values, \"m\"");
  series.description = table.optional_text("description", series.name);
  series.uncertainty = table.number("uncertainty", half_width);
  series.uncertainty_basis = table.prose("uncertainty_basis", "what the uncertainty rests on");
  table.finish();

  if (!follows_name_rule(series.name)) table.refuse_value("name", fmt::format("must be {}", name_rule));
  for (const Abscissa abscissa : {Abscissa::time, Abscissa::mode, Abscissa::load})
    if (series.name == word(abscissa))
      table.refuse_value("name", "is the name of what series stand over, the time, a mode or a load");
  const auto same = [&](const ReferenceSeries& other) { return other.name == series.name; };
  if (std::any_of(others.begin(), others.end(), same))
    table.refuse_value("name", "is the name of another series");
  return series;
}

/// The series of each column after the first, which is what they stand over.
std::vector<ReferenceSeries*> read_columns(const TableReader& file, const std::vector<TomlValue>& columns,
                                           std::vector<ReferenceSeries>& series, Abscissa& abscissa) {
  std::vector<std::string> names;
  for (const ReferenceSeries& item : series) names.push_back(item.name);
  std::vector<ReferenceSeries*> order;
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string key = fmt::format("columns.{}", i);
    const std::string name = file.text_in(columns[i], key);
    const auto fail = [&](const std::string& what) {
      refuse(columns[i].place, key, columns[i].written, what);
    };
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) fail("is the name of another column");
    seen.push_back(name);
    if (i == 0) {
      abscissa = name == word(Abscissa::mode)   ? Abscissa::mode
                 : name == word(Abscissa::load) ? Abscissa::load
                                                : Abscissa::time;
      if (name != word(abscissa))
        fail("the first column must be \"t\", the time, \"mode\", the number of a mode, or \"load\"");
      continue;
    }
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) fail("has no [[series]] of that name" + suggestion(name, names));
    order.push_back(&series[static_cast<std::size_t>(found - names.begin())]);
  }
  for (const std::string& name : names) {
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) continue;
    file.refuse_value("columns", fmt::format("lacks the series \"{}\"", name));
  }
  return order;
}

void read_rows(const TableReader& table, const std::vector<TomlValue>& rows,
               const std::vector<ReferenceSeries*>& order, Abscissa abscissa, std::vector<double>& times) {
  constexpr int most_modes = 1'000'000;
  const Range range_of_first = abscissa == Abscissa::time   ? Range::at_least(0, "s")
                               : abscissa == Abscissa::load ? Range::at_least(0, "")
                                                            : Range::whole_between(1, most_modes);
  if (rows.empty()) table.refuse_value("rows", "must hold at least one row");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TomlValue& row = rows[i];
    const std::string key = table.full_key(fmt::format("rows.{}", i));
    const std::size_t length = order.size() + 1;
    if (row.kind != TomlValue::Kind::array || row.items.size() != length) {
      refuse(row.place, key, row.written, fmt::format("must be a list of {} numbers, one a column", length));
    }
    const double time = table.number_in(row.items[0], key + ".0", range_of_first);
    if (!times.empty() && time <= times.back()) {
      refuse(row.items[0].place, key + ".0", row.items[0].written,
             fmt::format("must be greater than the {} before it, {}{}",
                         abscissa == Abscissa::time ? "time" : word(abscissa), times.back(),
                         abscissa == Abscissa::time ? " (s)" : ""));
    }
    times.push_back(time);
    for (std::size_t j = 1; j < length; ++j) {
      const Range range = Range::any(order[j - 1]->unit);
      order[j - 1]->values.push_back(table.number_in(row.items[j], fmt::format("{}.{}", key, j), range));
    }
  }
}

ReferenceCable read_cable_of(TableReader table) {
  ReferenceCable cable;
  cable.length = table.optional_number("length", Range::positive("m"));
  cable.axial_stiffness = table.optional_number("axial_stiffness", Range::positive("N"));
  cable.bending_stiffness = table.optional_number("bending_stiffness", Range::positive("N m²"));
  cable.mass_per_length = table.optional_number("mass_per_length", Range::positive("kg/m"));
  table.finish();
  return cable;
}

/// [exact]: its rows stand over the same as those of the file.
void read_exact(TableReader table, const std::vector<ReferenceSeries*>& order, Reference& reference) {
  ExactSolution exact;
  exact.obtained = table.prose("obtained", "how the exact figures were found");
  exact.uncertainty_basis = table.prose("uncertainty_basis", "what the uncertainty rests on");
  const TomlValue* uncertainty = table.value().find("uncertainty");
  if (uncertainty != nullptr && uncertainty->kind == TomlValue::Kind::table) {
    TableReader by_series = table.table("uncertainty");
    for (ReferenceSeries* series : order)
      series->exact_uncertainty = by_series.number(series->name, half_width);
    by_series.finish();
  } else {
    const double of_all = table.number("uncertainty", half_width);
    for (ReferenceSeries* series : order) {
      series->exact_uncertainty = of_all;
      if (uncertainty != nullptr && series->unit != order.front()->unit)
        table.refuse_value("uncertainty",
                           "must be a table of one a series, { tip_x = 1e-6 }, as their units differ");
    }
  }
  const std::vector<TomlValue>& rows = table.list("rows", "the list of rows, as those of the file");
  table.finish();

  std::vector<ReferenceSeries> figures(order.size());
  std::vector<ReferenceSeries*> columns;
  for (std::size_t k = 0; k < order.size(); ++k) {
    figures[k].unit = order[k]->unit;
    columns.push_back(&figures[k]);
  }
  std::vector<double> at;
  read_rows(table, rows, columns, reference.abscissa, at);
  if (at != reference.times)
    table.refuse_value("rows", "must have the same first column as the rows of the file");
  for (std::size_t k = 0; k < order.size(); ++k) order[k]->exact = std::move(figures[k].values);
  reference.exact = std::move(exact);
}

/// Refuses what cannot be the key of an uncertain input, which the case has.
void check_inputs(const TableReader& table, const std::vector<std::string>& inputs) {
  constexpr std::array tables = {"parameters.", "cable.", "start.", "loads.", "damping."};
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const std::string& input = inputs[k];
    const bool is_key = std::any_of(tables.begin(), tables.end(), [&](const char* name) {
      return input.starts_with(name) && input.size() > std::strlen(name);
    });
    if (!is_key || std::find(inputs.begin(), inputs.begin() + static_cast<std::ptrdiff_t>(k), input) !=
                       inputs.begin() + static_cast<std::ptrdiff_t>(k))
      table.refuse_value(
          "inputs",
          fmt::format("must name each input once, by its key in [[uncertainty.input]]: \"{}\"", input));
  }
}

SharedErrors read_shared_errors(TableReader table) {
  SharedErrors shares;
  constexpr int most_elements = 1'000'000, none = 0;
  if (const int elements = table.whole("elements", 1, most_elements, none); elements != none)
    shares.elements = elements;
  shares.strain = table.choice<StrainModel>("strain", shares.strain);
  shares.quadrature = table.choice<QuadratureRule>("quadrature", shares.quadrature);
  shares.inputs = table.proses("inputs");
  const bool has_inputs = table.has("inputs");
  shares.model = table.optional_prose("model");
  table.finish();
  if (has_inputs) check_inputs(table, shares.inputs);
  if (!shares.elements)
    for (const char* key : {"strain", "quadrature"})
      if (table.has(key)) table.refuse_value(key, "is of a mesh, whose number of elements is missing");
  return shares;
}

/// [model]
void read_other_model(TableReader table, const std::vector<ReferenceSeries*>& order, Reference& reference) {
  OtherModel model;
  table.list("differences", "the list of what is different in the model behind the figures");
  model.differences = table.proses("differences");
  if (table.has("error")) {
    TableReader by_series = table.table("error");
    for (ReferenceSeries* series : order)
      series->model_error = by_series.optional_number(series->name, Range::positive(series->unit));
    by_series.finish();
    model.error_basis = table.prose("error_basis", "what the size of the model error rests on");
  }
  const bool has_basis = table.has("error_basis");
  table.finish();
  if (has_basis && model.error_basis.empty())
    table.refuse_value("error_basis", "is asked for with error alone");
  if (!model.error_basis.empty() &&
      std::none_of(order.begin(), order.end(),
                   [](const ReferenceSeries* series) { return series->model_error.has_value(); }))
    table.refuse_value("error", "must have the error of one series or more, { tip = 5e-6 }");
  if (model.differences.empty() || std::count(model.differences.begin(), model.differences.end(), "") > 0)
    table.refuse_value("differences", "must hold at least one text, and none that is empty");
  reference.model = std::move(model);
}

}  // namespace

template <>
inline constexpr std::array words_of<ReferenceKind>{
    Word<ReferenceKind>{ReferenceKind::published, "published"},
    Word<ReferenceKind>{ReferenceKind::computed, "computed"},
};

Reference read_reference(const NamedText& text) {
  const TomlValue root = parse_toml(text);
  TableReader file(root, "", nullptr);
  Reference reference;
  reference.title = file.text("title", "a title");
  reference.kind = file.choice<ReferenceKind>("kind");
  reference.source = file.prose("source", "the publication or program that the numbers are from");
  reference.obtained = file.prose("obtained", "how the numbers came from the source");
  reference.notes = file.proses("notes");
  const bool has_unit = file.has("time_unit");
  if (has_unit) file.choice("time_unit", {"s"}, false);
  reference.cable = read_cable_of(file.table("cable"));
  const bool has_exact = file.has("exact"), has_model = file.has("model");
  TableReader exact = file.table("exact"), model = file.table("model");
  reference.shares = read_shared_errors(file.table("shares"));
  const std::vector<TableReader> series = file.tables("series");
  if (!file.has("series")) file.list("series", "a list of tables [[series]], one a column");
  const std::vector<TomlValue>& columns = file.list("columns", "the list of the columns' names, \"t\" first");
  const std::vector<TomlValue>& rows = file.list("rows", "the list of rows, each a list of numbers");
  file.finish();

  for (const TableReader& table : series) reference.series.push_back(read_series(table, reference.series));
  if (reference.series.empty()) file.refuse_value("series", "must hold at least one series");
  const std::vector<ReferenceSeries*> order =
      read_columns(file, columns, reference.series, reference.abscissa);
  if (reference.abscissa == Abscissa::time && !has_unit)
    file.refuse_value("columns", "stand over the time, whose time_unit = \"s\" is missing");
  read_rows(file, rows, order, reference.abscissa, reference.times);
  if (has_exact) read_exact(std::move(exact), order, reference);
  if (has_model) read_other_model(std::move(model), order, reference);
  return reference;
}

}  // namespace plumb
